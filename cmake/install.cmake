# What `cmake --install` puts in place: the program with its manual page and completions, the cases, one library of all
# modules with its headers, found by find_package(strandyn). CPack makes a Debian package of the same.
include(GNUInstallDirs)

install(TARGETS strandyn RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY include/strandyn ${PROJECT_BINARY_DIR}/include/strandyn DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DATADIR}/strandyn PATTERN refused EXCLUDE)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(DIRECTORY python/strandyn DESTINATION lib/python3/dist-packages PATTERN __pycache__ EXCLUDE)

# From the declarations of --help.
set(words ${PROJECT_BINARY_DIR}/words)
file(MAKE_DIRECTORY ${words})
add_custom_command(OUTPUT ${words}/strandyn.1 ${words}/strandyn.bash ${words}/_strandyn ${words}/strandyn.fish
                   COMMAND strandyn man > ${words}/strandyn.1
                   COMMAND strandyn completion bash > ${words}/strandyn.bash
                   COMMAND strandyn completion zsh > ${words}/_strandyn
                   COMMAND strandyn completion fish > ${words}/strandyn.fish
                   DEPENDS strandyn VERBATIM)
install(FILES ${words}/strandyn.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${words}/strandyn.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME strandyn)
install(FILES ${words}/_strandyn DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${words}/strandyn.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# One archive of all modules, and of SUNDIALS where that was unpacked and not installed.
set(archive ${PROJECT_BINARY_DIR}/libstrandyn.a)
set(script "create ${archive}\n")
set(parts "")
foreach(module IN LISTS modules)
  string(REPLACE "/" "_" target strandyn_${module})
  get_target_property(type ${target} TYPE)
  if(type STREQUAL STATIC_LIBRARY)
    string(APPEND script "addlib $<TARGET_FILE:${target}>\n")
    list(APPEND parts ${target})
  endif()
endforeach()
set(STRANDYN_NEEDS_SUNDIALS ON)
get_target_property(sundials_is_imported SUNDIALS::ida TYPE)
if(sundials_is_imported STREQUAL INTERFACE_LIBRARY)
  set(STRANDYN_NEEDS_SUNDIALS OFF)
  get_target_property(linked SUNDIALS::ida INTERFACE_LINK_LIBRARIES)
  foreach(library IN LISTS linked)
    if(TARGET ${library})
      string(APPEND script "addlib $<TARGET_FILE:${library}>\n")
      list(APPEND parts ${library})
    else()
      string(APPEND script "addlib ${library}\n")
    endif()
  endforeach()
endif()
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/libstrandyn.mri CONTENT "${script}save\nend\n")
add_custom_command(OUTPUT ${archive} COMMAND ${CMAKE_COMMAND} -E rm -f ${archive}
                   COMMAND ${CMAKE_AR} -M < ${PROJECT_BINARY_DIR}/libstrandyn.mri DEPENDS ${parts} VERBATIM)
add_custom_target(strandyn_installed ALL DEPENDS ${archive} ${words}/strandyn.1)
install(FILES ${archive} DESTINATION ${CMAKE_INSTALL_LIBDIR})

include(CMakePackageConfigHelpers)
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/strandyn)
configure_package_config_file(cmake/strandynConfig.cmake.in ${PROJECT_BINARY_DIR}/strandynConfig.cmake
                              INSTALL_DESTINATION ${config})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/strandynConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/strandynConfig.cmake ${PROJECT_BINARY_DIR}/strandynConfigVersion.cmake
        DESTINATION ${config})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the authors of strandyn <strandyn@localhost>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libeigen3-dev, libfmt-dev, libhwy-dev, libtomlplusplus-dev, nlohmann-json3-dev")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
include(CPack)
