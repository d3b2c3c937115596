# Tests of the whole program, and of what is installed. Sanitizer presets leave them out, and the program with them.
pleura_tests(commands x3d/commands pleura_headers)
target_sources(test_commands PRIVATE x3d/commands/run_program.cpp)
target_compile_definitions(test_commands PRIVATE PLEURA_PROGRAM="$<TARGET_FILE:pleura>")
add_dependencies(test_commands pleura plugins)
find_program(PLEURA_XDOTOOL xdotool)
find_package(X11)
if(PLEURA_XVFB_RUN AND PLEURA_XDOTOOL AND X11_FOUND)
  pleura_tests(play x3d/play X11::X11 pleura_headers)
  target_sources(test_play PRIVATE x3d/play/played_scene.cpp)
  target_compile_definitions(test_play PRIVATE PLEURA_PROGRAM="$<TARGET_FILE:pleura>")
  add_dependencies(test_play pleura plugins)
else()
  message(STATUS "xvfb-run, xdotool or libX11 is absent: nobody plays a scene by hand")
endif()

# Installs Pleura and builds somebody else's project against it.
set(installed ${CMAKE_CURRENT_BINARY_DIR}/installed)
add_test(NAME install COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${installed})
set_tests_properties(install PROPERTIES FIXTURES_SETUP installed)
add_test(NAME package COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/package
         ${CMAKE_CURRENT_BINARY_DIR}/package --build-generator ${CMAKE_GENERATOR} --build-options
         -DCMAKE_PREFIX_PATH=${installed} -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
         --test-command ${CMAKE_CTEST_COMMAND} --output-on-failure)
set_tests_properties(package PROPERTIES FIXTURES_REQUIRED installed TIMEOUT 600)
