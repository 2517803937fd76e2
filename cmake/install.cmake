# Installs the headers, the libraries, the program, and what find_package(provis) needs.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(provis_libraries)
foreach(folder predicates scene point segment offset lod region certify report)
  if(TARGET provis_${folder})
    list(APPEND provis_libraries provis_${folder})
  endif()
endforeach()

# What a program links: provis::provis is the whole library.
add_library(provis_all INTERFACE)
add_library(provis::provis ALIAS provis_all)
target_link_libraries(provis_all INTERFACE ${provis_libraries})
target_compile_features(provis_all INTERFACE cxx_std_20)
set_target_properties(provis_all PROPERTIES EXPORT_NAME provis)

set(provis_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/provis)
install(TARGETS ${provis_libraries} provis_all EXPORT provisTargets)
install(EXPORT provisTargets NAMESPACE provis:: DESTINATION ${provis_package_dir})
install(DIRECTORY include/provis DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
if(TARGET provis_cli)
  set_target_properties(provis_cli PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  install(TARGETS provis_cli)
endif()

write_basic_package_version_file(${PROJECT_BINARY_DIR}/provisConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES cmake/provisConfig.cmake cmake/FindMPFI.cmake ${PROJECT_BINARY_DIR}/provisConfigVersion.cmake
  DESTINATION ${provis_package_dir})
