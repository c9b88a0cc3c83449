# Manual pages from what each program says of itself; compressed, as Debian wants them.
find_program(QUICKSTRIP_HELP2MAN help2man)
if(NOT QUICKSTRIP_HELP2MAN OR CMAKE_CROSSCOMPILING OR CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  message(STATUS "Manual pages: left out of this build (they need help2man, and programs that run here)")
  return()
endif()

set(manual_pages)
function(quickstrip_manual_page program section summary)
  set(page ${CMAKE_CURRENT_BINARY_DIR}/${program}.${section})
  add_custom_command(OUTPUT ${page}.gz
    COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${QUICKSTRIP_HELP2MAN} --no-info --section=${section} --name=${summary}
            --source=Quickstrip --manual=Quickstrip --include=${CMAKE_CURRENT_SOURCE_DIR}/manual/common.h2m
            --output=${page} $<TARGET_FILE:${program}>
    COMMAND gzip -9nf ${page}
    DEPENDS ${program} ${CMAKE_CURRENT_SOURCE_DIR}/manual/common.h2m VERBATIM)
  install(FILES ${page}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section})
  set(manual_pages ${manual_pages} ${page}.gz PARENT_SCOPE)
endfunction()

quickstrip_manual_page(quickstrip-advisor 8 "onboard seakeeping advisor, the live process")
quickstrip_manual_page(quickstrip-display 8 "the bridge's page of the seakeeping advice")
quickstrip_manual_page(quickstrip-nmea 8 "gateway from NMEA 0183 to the seakeeping advisor")
quickstrip_manual_page(quickstrip-recorder 8 "records what the seakeeping advisor receives and sends")
quickstrip_manual_page(quickstrip-hull 1 "hull files and what follows from them")
quickstrip_manual_page(quickstrip-sim 1 "makes, replays and inspects logs of sea, ship and advice")
add_custom_target(quickstrip_manual ALL DEPENDS ${manual_pages})
