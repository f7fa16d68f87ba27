# Each claim as a test of its own: `goishi-verify --list` says which there are. Run after the suite is built, with -P.

execute_process(COMMAND "${SUITE}" --list OUTPUT_VARIABLE claims COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" lines "${claims}")
set(tests "")
foreach(line IN LISTS lines)
  if(line MATCHES "^([A-Z0-9-]+) +([a-z]+) ")
    set(name "verify.${CMAKE_MATCH_1}")
    string(APPEND tests
      "add_test([==[${name}]==] [==[${SUITE}]==] --filter [==[${CMAKE_MATCH_1}]==] --threads 1)\n"
      "set_tests_properties([==[${name}]==] PROPERTIES LABELS \"verify;${CMAKE_MATCH_2}\" TIMEOUT 120)\n")
  endif()
endforeach()
file(WRITE "${OUTPUT}" "${tests}")
