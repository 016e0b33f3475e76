#include "viewer/user_interface.h"

#include <imgui.h>

#include <array>
#include <filesystem>
#include <system_error>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>

#include "viewer/vulkan_check.h"
#include "viewer/vulkan_objects.h"

namespace opaline::app::viewer {

namespace {

void checkImGui(VkResult result) {
  check(result, "draw its controls");
}

// Fonts of common desktops; without one of them, ImGui's own of 13 pixels.
constexpr std::array fonts{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                           "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                           "/usr/share/fonts/TTF/DejaVuSans.ttf",
                           "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                           "/usr/share/fonts/google-noto/NotoSans-Regular.ttf",
                           "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf"};

void chooseColors() {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0;
  style.FrameRounding = 3;
  style.GrabRounding = 3;
  style.WindowBorderSize = 0;
  style.ItemSpacing = {8, 5};
  style.Colors[ImGuiCol_WindowBg] = {0.105F, 0.11F, 0.12F, 1};
  const ImVec4 amber{0.91F, 0.62F, 0.28F, 1};
  const auto shade = [&](float alpha) { return ImVec4(amber.x, amber.y, amber.z, alpha); };
  style.Colors[ImGuiCol_Header] = shade(0.22F);
  style.Colors[ImGuiCol_HeaderHovered] = shade(0.38F);
  style.Colors[ImGuiCol_HeaderActive] = shade(0.5F);
  style.Colors[ImGuiCol_SliderGrab] = shade(0.8F);
  style.Colors[ImGuiCol_SliderGrabActive] = amber;
  style.Colors[ImGuiCol_CheckMark] = amber;
  style.Colors[ImGuiCol_Button] = shade(0.25F);
  style.Colors[ImGuiCol_ButtonHovered] = shade(0.42F);
  style.Colors[ImGuiCol_ButtonActive] = shade(0.6F);
  style.Colors[ImGuiCol_FrameBg] = {0.19F, 0.195F, 0.21F, 1};
  style.Colors[ImGuiCol_FrameBgHovered] = {0.26F, 0.265F, 0.28F, 1};
  style.Colors[ImGuiCol_FrameBgActive] = {0.31F, 0.315F, 0.33F, 1};
  style.Colors[ImGuiCol_PlotHistogram] = amber;
}

}  // namespace

UserInterface::UserInterface(const VulkanDevice& device, const Presenter& presenter,
                             const Window& window)
    : device_(device) {
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 8};
  VkDescriptorPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  pool.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
  pool.maxSets = 8;
  pool.poolSizeCount = 1;
  pool.pPoolSizes = &size;
  check(vkCreateDescriptorPool(device_.device, &pool, nullptr, &pool_), "prepare its controls");

  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // ViewerState keeps what is to be kept
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  chooseColors();
  ImGui::GetStyle().ScaleAllSizes(window.scale());
  makeFonts(window.scale());
  ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
  ImGui_ImplVulkan_InitInfo info{};
  info.Instance = device_.instance;
  info.PhysicalDevice = device_.physicalDevice;
  info.Device = device_.device;
  info.QueueFamily = device_.queueFamily;
  info.Queue = device_.queue;
  info.DescriptorPool = pool_;
  info.MinImageCount = 2;
  info.ImageCount = static_cast<std::uint32_t>(Presenter::framesInFlight);
  info.CheckVkResultFn = checkImGui;
  ImGui_ImplVulkan_Init(&info, presenter.renderPass());
  uploadFonts();
}

UserInterface::~UserInterface() {
  vkDeviceWaitIdle(device_.device);
  ImGui_ImplVulkan_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  vkDestroyDescriptorPool(device_.device, pool_, nullptr);
}

void UserInterface::makeFonts(float scale) const {
  ImGuiIO& io = ImGui::GetIO();
  for (const char* font : fonts) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(font, error)) continue;
    if (io.Fonts->AddFontFromFileTTF(font, 15.0F * scale) != nullptr) return;
  }
  io.Fonts->AddFontDefault();
  io.FontGlobalScale = scale;
}

void UserInterface::uploadFonts() const {
  runOnce(device_, ImGui_ImplVulkan_CreateFontsTexture, "prepare its controls");
  ImGui_ImplVulkan_DestroyFontUploadObjects();
}

void UserInterface::begin() {
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void UserInterface::end() {
  ImGui::Render();
}

void UserInterface::draw(VkCommandBuffer commands) const {
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
}

}  // namespace opaline::app::viewer
