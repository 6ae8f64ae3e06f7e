# The program that draws the book's figures, on the best code that was given. Not part of `all`.
file(GLOB figure_sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/*.cpp")
add_executable(book_figures EXCLUDE_FROM_ALL ${figure_sources})
# A live figure is first shown as a picture.
set(shared_with_browser live_figure.cpp world_canvas.cpp body_order.cpp)
list(TRANSFORM shared_with_browser PREPEND "${PROJECT_SOURCE_DIR}/docs/live/")
target_sources(book_figures PRIVATE ${shared_with_browser})
target_include_directories(book_figures PRIVATE "${PROJECT_SOURCE_DIR}/docs/live")
target_link_libraries(book_figures PRIVATE cs550_pages cs550_engine cs550_drawing CLI11::CLI11 cs550_warnings)
target_compile_definitions(book_figures PRIVATE
  CS550_RECORDED_BENCHMARKS="${CMAKE_CURRENT_LIST_DIR}/benchmarks.json")
cs550_unity(book_figures 12)
cs550_optimise_little(book_figures)
cs550_link_labs(book_figures fast reference assembled stub)  # in a students' copy: their own
