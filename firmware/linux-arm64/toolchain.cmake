# 64-bit Arm Linux by Debian's cross compiler, against the folder that make_sysroot makes.
#   -DQUICKSTRIP_SYSROOT=...   that folder
#   -DQUICKSTRIP_EMULATE=ON    programs that this machine runs (run_emulated): for the tests, not to be deployed
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES QUICKSTRIP_SYSROOT QUICKSTRIP_EMULATE)
if(NOT IS_DIRECTORY "${QUICKSTRIP_SYSROOT}")
  message(FATAL_ERROR "QUICKSTRIP_SYSROOT is no folder: \"${QUICKSTRIP_SYSROOT}\" (firmware/linux-arm64/make_sysroot)")
endif()
get_filename_component(QUICKSTRIP_SYSROOT "${QUICKSTRIP_SYSROOT}" ABSOLUTE)

set(CMAKE_SYSROOT "${QUICKSTRIP_SYSROOT}")
set(CMAKE_FIND_ROOT_PATH "${QUICKSTRIP_SYSROOT}")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)  # lcm-gen and the tools of the tests are this machine's
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# A program under its own name is then a script that starts the emulator. So whoever starts it, a test, a shell script or
# an emulated program, needs not know, and the kernel needs no entry for foreign programs.
if(QUICKSTRIP_EMULATE)
  set(link "<CMAKE_CXX_COMPILER> <FLAGS> <CMAKE_CXX_LINK_FLAGS> <LINK_FLAGS> <OBJECTS> -o <TARGET> <LINK_LIBRARIES>")
  set(CMAKE_CXX_LINK_EXECUTABLE "${link}" "${CMAKE_CURRENT_LIST_DIR}/run_emulated <TARGET> ${QUICKSTRIP_SYSROOT}")
endif()
