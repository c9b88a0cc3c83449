find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Threads REQUIRED)

# toml++ is header-only in our use; Debian ships it without a CMake package.
find_path(TOMLPLUSPLUS_INCLUDE_DIR toml++/toml.h REQUIRED)
add_library(quickstrip_tomlplusplus INTERFACE)
target_include_directories(quickstrip_tomlplusplus SYSTEM INTERFACE ${TOMLPLUSPLUS_INCLUDE_DIR})
target_compile_definitions(quickstrip_tomlplusplus INTERFACE TOML_HEADER_ONLY=1)

# LCM 1.3.1 as Debian packages it has no CMake package either.
find_path(LCM_INCLUDE_DIR lcm/lcm-cpp.hpp REQUIRED)
find_library(LCM_LIBRARY lcm REQUIRED)
find_program(LCM_GEN lcm-gen REQUIRED)
add_library(quickstrip_lcm INTERFACE)
target_include_directories(quickstrip_lcm SYSTEM INTERFACE ${LCM_INCLUDE_DIR})
target_link_libraries(quickstrip_lcm INTERFACE ${LCM_LIBRARY})

# cpp-httplib as Debian packages it: a shared library whose classes have other layouts without these three.
find_path(CPP_HTTPLIB_INCLUDE_DIR httplib.h REQUIRED)
find_library(CPP_HTTPLIB_LIBRARY cpp-httplib REQUIRED)
add_library(quickstrip_httplib INTERFACE)
target_include_directories(quickstrip_httplib SYSTEM INTERFACE ${CPP_HTTPLIB_INCLUDE_DIR})
target_compile_definitions(quickstrip_httplib INTERFACE
  CPPHTTPLIB_OPENSSL_SUPPORT CPPHTTPLIB_ZLIB_SUPPORT CPPHTTPLIB_BROTLI_SUPPORT)
target_link_libraries(quickstrip_httplib INTERFACE ${CPP_HTTPLIB_LIBRARY} Threads::Threads)
