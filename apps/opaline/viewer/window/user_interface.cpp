#include "viewer/window/user_interface.h"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <system_error>
#include <vector>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>

#include "viewer/window/font_files.h"
#include "viewer/window/glyphs.h"
#include "viewer/window/vulkan_check.h"
#include "viewer/window/vulkan_objects.h"

namespace opaline::app::viewer {

namespace {

void checkImGui(VkResult result) {
  check(result, "draw its controls");
}

constexpr std::uintmax_t largestFontBytes = 256U << 20U;

// Empty where the file cannot be read.
std::vector<char> contentsOf(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  if (error || bytes == 0 || bytes > largestFontBytes) return {};
  std::vector<char> contents(bytes);
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(contents.data(), static_cast<std::streamsize>(bytes))) return {};
  return contents;
}

// Latin, and those of the wanted characters that this font has.
ImVector<ImWchar> rangesOf(const FontFile& font) {
  ImFontGlyphRangesBuilder builder;
  builder.AddRanges(ImGui::GetIO().Fonts->GetGlyphRangesDefault());
  for (const char32_t character : font.has) {
    if (character <= std::numeric_limits<ImWchar>::max()) {
      builder.AddChar(static_cast<ImWchar>(character));
    }
  }
  ImVector<ImWchar> ranges;
  builder.BuildRanges(&ranges);
  return ranges;
}

void chooseColors() {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0;
  style.FrameRounding = 3;
  style.GrabRounding = 3;
  style.WindowBorderSize = 0;
  style.ItemSpacing = {8, 5};
  style.Colors[ImGuiCol_WindowBg] = {0.105F, 0.11F, 0.12F, 1};
  style.Colors[ImGuiCol_PopupBg] = {0.135F, 0.14F, 0.15F, 1};
  style.PopupBorderSize = 1;
  const ImVec4 amber{0.91F, 0.62F, 0.28F, 1};
  const auto shade = [&](float alpha) { return ImVec4(amber.x, amber.y, amber.z, alpha); };
  style.Colors[ImGuiCol_Header] = shade(0.22F);
  style.Colors[ImGuiCol_HeaderHovered] = shade(0.38F);
  style.Colors[ImGuiCol_HeaderActive] = shade(0.5F);
  // Dark enough that the value on it is legible.
  style.Colors[ImGuiCol_SliderGrab] = {0.45F, 0.30F, 0.13F, 1};
  style.Colors[ImGuiCol_SliderGrabActive] = {0.55F, 0.37F, 0.16F, 1};
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
    : device_(device), presenter_(presenter), window_(window) {
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
  io.IniFilename = nullptr;  // ViewerState keeps what needs keeping
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  chooseColors();
  ImGui::GetStyle().ScaleAllSizes(window.scale());
  ImGui_ImplGlfw_InitForVulkan(window.handle(), false);
  glfwSetWindowFocusCallback(window.handle(), ImGui_ImplGlfw_WindowFocusCallback);
  beginDrawing();
}

UserInterface::~UserInterface() {
  vkDeviceWaitIdle(device_.device);
  ImGui_ImplVulkan_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  vkDestroyDescriptorPool(device_.device, pool_, nullptr);
}

void UserInterface::beginDrawing() {
  makeFonts();
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
  ImGui_ImplVulkan_Init(&info, presenter_.renderPass());
  uploadFonts();
}

void UserInterface::makeFonts() {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  ranges_.clear();
  for (const FontFile& font : fontsFor(glyphs::wanted())) {
    const std::vector<char> contents = contentsOf(font.file);
    if (contents.empty()) continue;
    ImFontConfig config;
    config.MergeMode = atlas.Fonts.Size > 0;
    config.FontNo = font.index;
    ranges_.push_back(rangesOf(font));
    void* const owned = ImGui::MemAlloc(contents.size());
    std::memcpy(owned, contents.data(), contents.size());
    atlas.AddFontFromMemoryTTF(owned, static_cast<int>(contents.size()), 15.0F * window_.scale(),
                               &config, ranges_.back().Data);
  }
  if (atlas.Fonts.Size > 0) return;
  atlas.AddFontDefault();
  ImGui::GetIO().FontGlobalScale = window_.scale();
}

void UserInterface::uploadFonts() const {
#if IMGUI_VERSION_NUM >= 19000
  // This submits commands of its own.
  if (!ImGui_ImplVulkan_CreateFontsTexture()) check(VK_ERROR_UNKNOWN, "prepare its controls");
#else
  runOnce(device_, ImGui_ImplVulkan_CreateFontsTexture, "prepare its controls");
  ImGui_ImplVulkan_DestroyFontUploadObjects();
#endif
}

void UserInterface::take(const Input& input) {
  GLFWwindow* const window = window_.handle();
  switch (input.kind) {
    case Input::Kind::Key:
      ImGui_ImplGlfw_KeyCallback(window, input.code, input.scanCode, input.action, input.modifiers);
      break;
    case Input::Kind::Text:
      ImGui_ImplGlfw_CharCallback(window, input.typed);
      break;
    case Input::Kind::Button:
      if (input.code < ImGuiMouseButton_COUNT)
        buttons_[static_cast<std::size_t>(input.code)] = input.isPress();
      break;
    case Input::Kind::Wheel:
      ImGui_ImplGlfw_ScrollCallback(window, input.x, input.y);
      break;
    case Input::Kind::Pointer:
      pointer_ = ImVec2(static_cast<float>(input.x), static_cast<float>(input.y));
      break;
    case Input::Kind::Left:
      pointer_.reset();
      break;
  }
}

// Replaces the mouse's current state, which may be newer than the inputs.
void UserInterface::setMouse() const {
  ImGuiIO& io = ImGui::GetIO();
  if (pointer_) io.MousePos = *pointer_;
  std::copy(buttons_.begin(), buttons_.end(), io.MouseDown);
}

void UserInterface::begin(const std::vector<Input>& inputs) {
  if (glyphs::takeNews()) {
    check(vkDeviceWaitIdle(device_.device), "wait for the device");
    ImGui_ImplVulkan_Shutdown();
    beginDrawing();
  }
  ImGui_ImplVulkan_NewFrame();
  for (const Input& input : inputs) take(input);
  ImGui_ImplGlfw_NewFrame();
  setMouse();
  ImGui::NewFrame();
}

void UserInterface::end() {
  ImGui::Render();
}

void UserInterface::draw(VkCommandBuffer commands) const {
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
}

}  // namespace opaline::app::viewer
