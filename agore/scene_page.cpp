#include "agore/scene_page.hpp"

#include "agore/scene_data.hpp"
#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/write_folder.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/image_export.hpp"

#include <QFile>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace adore::agore {
namespace {

namespace fs = std::filesystem;

constexpr double kThreeBytes = 0.87e6, kFixedBytes = 60e3;
/// License of three.js, which each copy must contain.
constexpr const char* kLicence = R"(three.js, MIT License
Copyright (c) 2010-2019 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.)";

/// Frames of the range, from 0, first and last.
std::pair<std::size_t, std::size_t> range_of(const Animation& animation,
                                             const ScenePageOptions& options) {
  // Frames behind the end of RESULTS.h5 have neither loads nor all digits.
  const auto frames = static_cast<int>(animation.exact);
  const int last = options.last > 0 ? std::min(options.last, frames) : frames;
  if (options.first < 1 || options.first > last)
    throw InputError(fmt::format(
        "frames {} to {}: the file has frames 1 to {}. Enter a range within these frames.",
        options.first, options.last, frames));
  return {static_cast<std::size_t>(options.first - 1), static_cast<std::size_t>(last - 1)};
}

std::string escape_html(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else
      out += c;
  }
  return out;
}

/// A text in a script element must not end it: "<\\/" means "</" in strings of JSON and scripts.
std::string script_text(std::string text, std::string_view end) {
  for (std::size_t at = 0; (at = text.find(end, at)) != std::string::npos; at += 2)
    text.insert(at + 1, 1, '\\');
  return text;
}

std::string page_template() {
  QFile file(":/adore/scene/scene.html");
  const bool there = file.open(QIODevice::ReadOnly);
  demand(there, "the built-in page of the 3D scene is missing");
  return file.readAll().toStdString();
}

}  // namespace

std::string ScenePage::summary() const {
  return fmt::format("{}{}, {} MB", counted(static_cast<double>(frames), "frame"),
                     every > 1 ? fmt::format(" (one of every {})", every) : std::string(),
                     desktop::pretty_number(1e-6 * static_cast<double>(html.size()), 2));
}

bool is_threejs_installed() {
  std::error_code none;
  return fs::exists(kThreeFile, none);
}

ScenePageSize scene_page_size(const Animation& animation, const ScenePageOptions& options) {
  const auto [first, last] = range_of(animation, options);
  const double each = scene_frame_bytes(animation);
  const auto count = static_cast<double>(last - first + 1);
  ScenePageSize out;
  out.every = options.every > 0
                  ? options.every
                  : std::max(1, static_cast<int>(std::ceil(count * each / kMostBytes)));
  out.frames = (last - first) / static_cast<std::size_t>(out.every) + 1;
  out.bytes = kThreeBytes + kFixedBytes + each * static_cast<double>(out.frames);
  return out;
}

ScenePage scene_page(const Animation& animation, const ScenePageOptions& options,
                     const fs::path& three) {
  if (const std::string reason = why_not(View::Solid, animation); !reason.empty())
    throw InputError(reason);
  std::error_code none;
  if (!fs::exists(three, none))
    throw InputError(
        fmt::format("{} is missing: a page with the 3D scene needs three.js. Install "
                    "the package libjs-three.",
                    three.string()));
  const ScenePageSize size = scene_page_size(animation, options);
  const std::string library = read_text_file(three);
  const std::string data = script_text(
      scene_data(animation, options.view, range_of(animation, options), size.every), "</");
  const std::string& run = animation.file.run_id;
  const std::pair<std::string_view, std::string> parts[] = {
      {"{{title}}", escape_html(run.empty() ? "Bearing" : run)},
      {"{{licence}}", kLicence},
      {"{{three}}", script_text(library, "</script")},
      {"{{data}}", data}};
  ScenePage out{page_template(), size.frames, size.every};
  std::size_t at = 0;  // a text that is put in is not searched
  for (const auto& [name, text] : parts) {
    at = out.html.find(name, at);
    demand(at != std::string::npos, "the page of the 3D scene lacks a placeholder");
    out.html.replace(at, name.size(), text);
    at += text.size();
  }
  return out;
}

ScenePage write_scene_page(const Animation& animation, const ScenePageOptions& options,
                           const fs::path& file, bool replace) {
  std::string suffix = file.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix != ".html" && suffix != ".htm")
    throw InputError(
        fmt::format("{}: a page with the 3D scene is an HTML file. Enter a name that "
                    "ends in .html.",
                    file.string()));
  ScenePage page = scene_page(animation, options);
  if (file.has_parent_path()) desktop::make_folder(file.parent_path());
  if (!replace) desktop::check_replaceable(file);
  write_file_atomically(file, page.html);
  return page;
}

}  // namespace adore::agore
