# CPack's Debian package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME quickstrip)
set(CPACK_PACKAGE_VENDOR Quickstrip)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "Quickstrip maintainers <maintainers@quickstrip.example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "onboard seakeeping advisor")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "systemd, iproute2")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Tells the bridge, each second, what the ship will do in the present sea on
every course and speed, which limit governs and what change helps most:
strip theory on board, in fixed memory and bounded time. With the bridge's
display in a browser, a gateway for NMEA 0183, a recorder, and the tools for
hull files and logs.")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA
  ${CMAKE_CURRENT_SOURCE_DIR}/debian/conffiles
  ${CMAKE_CURRENT_SOURCE_DIR}/debian/postinst
  ${CMAKE_CURRENT_SOURCE_DIR}/debian/prerm
  ${CMAKE_CURRENT_SOURCE_DIR}/debian/postrm)

# Debian wants its changelog, compressed.
set(changelog ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian.gz)
execute_process(COMMAND gzip -9nc ${CMAKE_CURRENT_SOURCE_DIR}/debian/changelog OUTPUT_FILE ${changelog}
  RESULT_VARIABLE failed)
if(NOT failed)
  install(FILES ${changelog} DESTINATION ${CMAKE_INSTALL_DOCDIR})
endif()
include(CPack)
