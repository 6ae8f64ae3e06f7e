# docs.book: opens the pages of the built book in headless browsers, docs.code those that hold nothing but code or
# names. Both are skipped if the book is not built.
if(CS550_HAS_BROWSER)
  add_test(NAME docs.book
           COMMAND "${CS550_SYSTEM_PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/book_test.py"
                   "${PROJECT_SOURCE_DIR}/build/docs/html")
  add_test(NAME docs.code
           COMMAND "${CS550_SYSTEM_PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/book_test.py"
                   "${PROJECT_SOURCE_DIR}/build/docs/html" --code)
  # docs.live: every figure that answers. Skipped where the book was built without emscripten.
  add_test(NAME docs.live
           COMMAND "${CS550_SYSTEM_PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/live_test.py"
                   "${PROJECT_SOURCE_DIR}/build/docs/html" $<TARGET_FILE:cs550_demo>)
  # Each starts a browser for every processor.
  set_tests_properties(docs.book docs.live PROPERTIES LABELS "docs;long")
  set_tests_properties(docs.code PROPERTIES LABELS pages)
  set_tests_properties(docs.book docs.code docs.live PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 900 RUN_SERIAL ON)
endif()

# docs.firefox: the figures that answer, in another browser. Skipped where Firefox, the library that speaks to it or
# live figures are missing.
if(CS550_SYSTEM_PYTHON AND NOT CMAKE_CXX_FLAGS_DEBUG MATCHES "-fsanitize")
  add_test(NAME docs.firefox
           COMMAND "${CS550_SYSTEM_PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/firefox_test.py"
                   "${PROJECT_SOURCE_DIR}/build/docs/html")
  set_tests_properties(docs.firefox PROPERTIES LABELS "docs;long" SKIP_RETURN_CODE 77 TIMEOUT 600)
endif()

# docs.listings: functions that chapters show are cut from the source. docs.markup: pages have no misspelt forms.
# docs.search: the text that the search finds.
if(CS550_SYSTEM_PYTHON)
  add_test(NAME docs.listings COMMAND "${CS550_SYSTEM_PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/listing_test.py")
  add_test(NAME docs.markup COMMAND "${CS550_SYSTEM_PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/markup_test.py")
  add_test(NAME docs.search COMMAND "${CS550_SYSTEM_PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/search_test.py")
  set_tests_properties(docs.listings docs.markup docs.search PROPERTIES LABELS docs TIMEOUT 60)
endif()

# docs.figure: one figure by its name.
add_test(NAME docs.figure COMMAND bash "${CMAKE_CURRENT_LIST_DIR}/figure_test.sh"
         "${PROJECT_SOURCE_DIR}/build/release/bin/book_figures" "${CMAKE_CURRENT_BINARY_DIR}/figure_test")
set_tests_properties(docs.figure PROPERTIES LABELS docs SKIP_RETURN_CODE 77 TIMEOUT 60)

# docs.rebuild.*: what docs/rebuild computes from the book's text alone agrees with the engine. The boxes are
# skipped until the book's tables are made. A students' copy may have the scripts, but its tables are the student's.
file(GLOB rebuild_scripts "${PROJECT_SOURCE_DIR}/docs/rebuild/*.py")
if(CS550_SYSTEM_PYTHON AND rebuild_scripts AND NOT CS550_STUDENTS_COPY)
  execute_process(COMMAND "${CS550_SYSTEM_PYTHON}" -c "import numpy" RESULT_VARIABLE without_numpy
                  OUTPUT_QUIET ERROR_QUIET)
  if(without_numpy)
    message(STATUS "Tests docs.rebuild.* are left out: Python has no NumPy (python3-numpy)")
    return()
  endif()
  set(rebuild "${PROJECT_SOURCE_DIR}/docs/rebuild")
  add_test(NAME docs.rebuild.SeparatingAxis COMMAND "${CS550_SYSTEM_PYTHON}" "${rebuild}/separating_axis.py"
           "${PROJECT_SOURCE_DIR}/build/docs/data/rebuild_boxes.dat")
  add_test(NAME docs.rebuild.ContactManifold COMMAND "${CS550_SYSTEM_PYTHON}" "${rebuild}/contact_manifold.py"
           "${PROJECT_SOURCE_DIR}/build/docs/data/rebuild_boxes.dat")
  add_test(NAME docs.rebuild.Stack COMMAND "${CS550_SYSTEM_PYTHON}" "${rebuild}/compare_stack.py"
           $<TARGET_FILE:cs550_demo>)
  set_tests_properties(docs.rebuild.SeparatingAxis docs.rebuild.ContactManifold docs.rebuild.Stack
                       PROPERTIES LABELS docs SKIP_RETURN_CODE 77 TIMEOUT 120)
endif()
