# What the board runs beside the core and the host build of the same profile too. Paths from the root.
set(QUICKSTRIP_M7_SESSION_SOURCES
  firmware/cortex-m7/serial/framing.cpp
  firmware/cortex-m7/serial/serial_session.cpp
  firmware/cortex-m7/ship/table.cpp
  firmware/session/alerts.cpp
  firmware/session/allow_list.cpp
  firmware/session/inputs.cpp
  firmware/session/self_test.cpp
  firmware/session/session.cpp
  firmware/session/session_messages.cpp
  firmware/session/session_small.cpp
  msgs/convert/advice_message.cpp
  msgs/convert/advice_text.cpp
  msgs/convert/change_text.cpp
  msgs/convert/digest.cpp
  msgs/convert/hazard_text.cpp
  msgs/convert/limits_message.cpp
  msgs/convert/motion_message.cpp
  msgs/convert/own_messages.cpp
  msgs/convert/received_checks.cpp
  msgs/convert/refusal.cpp
  msgs/convert/response_message.cpp
  msgs/convert/sea_message.cpp
  msgs/convert/ship_message.cpp
  msgs/convert/spectrum_message.cpp
  msgs/convert/uncertainty.cpp
  msgs/convert/why_text.cpp)

# quickstrip_m7_session(TARGET ROOT DIR SHIP FILE TABLE FILE MORE FILE... LIBRARIES LIBRARY...)
function(quickstrip_m7_session target)
  cmake_parse_arguments(ARG "" "ROOT;SHIP;TABLE" "MORE;LIBRARIES" ${ARGN})
  list(TRANSFORM QUICKSTRIP_M7_SESSION_SOURCES PREPEND ${ARG_ROOT}/ OUTPUT_VARIABLE sources)
  set(table ${ARG_ROOT}/firmware/cortex-m7/ship/table.S)
  set_source_files_properties(${table} PROPERTIES
    LANGUAGE C
    COMPILE_OPTIONS -xassembler-with-cpp
    COMPILE_DEFINITIONS "QUICKSTRIP_HULL_TABLE=\"${ARG_TABLE}\""
    OBJECT_DEPENDS ${ARG_TABLE})
  add_library(${target} STATIC ${sources} ${ARG_SHIP} ${table} ${ARG_MORE})
  set_target_properties(${target} PROPERTIES EXPORT_COMPILE_COMMANDS OFF)  # clang-tidy reads each file once
  target_link_libraries(${target} PUBLIC ${ARG_LIBRARIES} PRIVATE quickstrip_warnings)
endfunction()
