#include "viewer/ui/interface.hpp"

#include <GLFW/glfw3.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_opengl3.h>
#include <imgui/imgui.h>

#include "viewer/ui/layout.hpp"

namespace cs550::viewer {

Interface::Interface(GLFWwindow* window, float scale)
    : window_(window), full_scale_(scale), scale_(scale) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // no saved window positions: every start is the same
  fonts_ = apply_theme(scale);
  if (window_ != nullptr) ImGui_ImplGlfw_InitForOpenGL(window_, true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

Interface::~Interface() {
  ImGui_ImplOpenGL3_Shutdown();
  if (window_ != nullptr) ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

/// Window coordinates may be larger than pixels.
Size Interface::size_for(Size canvas) const {
  if (window_ == nullptr) return canvas;
  Size size;
  glfwGetWindowSize(window_, &size.width, &size.height);
  return size;
}

void Interface::set_scale(float scale) {
  if (scale == scale_) return;
  scale_ = scale;
#if IMGUI_VERSION_NUM < 19200
  // Before Dear ImGui 1.92, all fonts share one texture, which is created with the first frame.
  const bool is_on_card = ImGui::GetIO().Fonts->TexID != ImTextureID{};
  if (is_on_card) ImGui_ImplOpenGL3_DestroyFontsTexture();
#endif
  ImGui::GetIO().Fonts->Clear();
  fonts_ = apply_theme(scale);
#if IMGUI_VERSION_NUM < 19200
  if (is_on_card) ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

void Interface::begin_frame(Size canvas, bool has_panels) {
  const Size size = size_for(canvas);
  set_scale(has_panels ? panel_scale(size, full_scale_) : full_scale_);
  ImGui_ImplOpenGL3_NewFrame();
  if (window_ != nullptr) {
    frame_start_ = glfwGetTime();
    ImGui_ImplGlfw_NewFrame();
  } else {
    ImGui::GetIO().DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
    ImGui::GetIO().DeltaTime = 1.0F / 60;
  }
  ImGui::NewFrame();
}

double Interface::time_in_frame() const {
  return window_ != nullptr ? glfwGetTime() - frame_start_ : 0;
}

void Interface::end_frame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace cs550::viewer
