# CS550_HAS_BROWSER: whether tests can look at pages in a headless browser. They need Python's selenium and a driver.
find_program(CS550_SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)

# Ubuntu's package holds a script that asks for a snap.
function(cs550_check_that_it_starts result program)
  execute_process(COMMAND "${program}" --version RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
  if(NOT code EQUAL 0)
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()
find_program(CS550_CHROMEDRIVER chromedriver VALIDATOR cs550_check_that_it_starts)

set(CS550_HAS_BROWSER FALSE)
if(CS550_CHROMEDRIVER AND CS550_SYSTEM_PYTHON AND NOT CMAKE_CXX_FLAGS_DEBUG MATCHES "-fsanitize")
  execute_process(COMMAND "${CS550_SYSTEM_PYTHON}" -c "import selenium" RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
  if(code EQUAL 0)
    set(CS550_HAS_BROWSER TRUE)
  endif()
endif()
