# docs.book: the built book, page by page, in a headless browser. Only where a driver and its Python module
# are installed; skipped where the book is not built. Sanitizers have nothing to say about it.
find_program(CS550_CHROMEDRIVER chromedriver)
find_program(CS550_SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(CS550_CHROMEDRIVER AND CS550_SYSTEM_PYTHON AND NOT CMAKE_CXX_FLAGS_DEBUG MATCHES "-fsanitize")
  execute_process(COMMAND "${CS550_SYSTEM_PYTHON}" -c "import selenium" RESULT_VARIABLE without_selenium
                  OUTPUT_QUIET ERROR_QUIET)
  if(NOT without_selenium)
    add_test(NAME docs.book
             COMMAND "${CS550_SYSTEM_PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/book_test.py"
                     "${PROJECT_SOURCE_DIR}/build/docs/html")
    set_tests_properties(docs.book PROPERTIES LABELS "docs;long" SKIP_RETURN_CODE 77 TIMEOUT 900)
  endif()
endif()
