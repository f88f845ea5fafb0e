#include "adrplot/render.hpp"

#include "adrplot/finding_pages.hpp"
#include "adrplot/folder_files.hpp"
#include "adrplot/spectrogram_page.hpp"
#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/input_limits.hpp"
#include "desktop/chart_scene.hpp"
#include "desktop/findings_bar.hpp"
#include "desktop/image_export.hpp"
#include "desktop/page_export.hpp"
#include "results/run_findings.hpp"

#include <QImage>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace adore::adrplot {

namespace fs = std::filesystem;

/// "2000:8000"
static PassBand band_of(const std::string& text) {
  PassBand out;
  const char* const end = text.data() + text.size();
  const auto low = std::from_chars(text.data(), end, out.low);
  const bool separated = low.ec == std::errc() && low.ptr != end && *low.ptr == ':';
  const auto high = separated ? std::from_chars(low.ptr + 1, end, out.high) : low;
  if (!separated || high.ec != std::errc() || high.ptr != end || !(out.low >= 0.0) ||
      !(out.high > out.low) || !std::isfinite(out.high))
    throw InputError(fmt::format(
        "--band = {}: not a band of frequencies. Give the lower and the higher frequency in Hz, "
        "such as 2000:8000",
        text));
  return out;
}

void parse_domain_options(PageOptions& view, const std::string& domain, const std::string& curve,
                          const std::string& scale, const std::string& rows,
                          const std::string& band, const std::string& orders_of) {
  const auto index_of = [](const auto& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? 0 : found - names.begin();
  };
  view.domain = static_cast<Domain>(index_of(kDomainNames, domain));
  if (!curve.empty() && view.domain != Domain::Spectrogram)
    throw InputError("--curve selects the curve of a spectrogram and needs --domain spectrogram");
  if (!rows.empty() && view.domain != Domain::Spectrogram)
    throw InputError("--rows selects the rows of a spectrogram and needs --domain spectrogram");
  if (!scale.empty() && view.domain == Domain::History)
    throw InputError(
        "--scale is for spectra and needs --domain spectrum, envelope, orders or spectrogram");
  if (!band.empty() && view.domain != Domain::Envelope)
    throw InputError("--band selects the band of an envelope and needs --domain envelope");
  if (!orders_of.empty() && view.domain != Domain::Envelope && view.domain != Domain::Orders)
    throw InputError(
        "--orders-of selects the part that orders refer to and needs --domain orders or envelope");
  view.spectrum.band = band.empty() ? PassBand{} : band_of(band);
  view.spectrum.orders_of = static_cast<OrderReference>(index_of(kOrderReferenceNames, orders_of));
  view.spectrogram_of = curve;
  view.spectrum.over_speed = rows == "speed";
  view.spectrum.scale = scale == "units"      ? SpectrumScale::Units
                        : scale == "db"       ? SpectrumScale::Decibel
                        : scale == "relative" ? SpectrumScale::Relative
                                              : SpectrumScale::Automatic;
}

namespace {

/// Draws the pages that are wanted; of others, without the curve that is, the curves are noted.
std::vector<fs::path> draw_document(const PlotDocument& document, const std::string& stem,
                                    const RenderOptions& options, std::string& others) {
  std::vector<fs::path> written;
  const std::vector<Finding> findings = results::run_findings(document.path);
  desktop::ChartScene scene;
  scene.setTheme(
      desktop::theme(options.dark ? desktop::ThemeKind::Dark : desktop::ThemeKind::Light));
  const int first = options.page == 0 ? 1 : options.page;
  const int last = options.page == 0 ? static_cast<int>(document.pages.size()) : options.page;
  for (int number = first; number <= last; ++number) {
    scene.setPageSize(QSizeF(options.width, options.height));
    desktop::ChartPage page = document.build(number, options.view);
    // A curve that is selected by name needs the pages that contain it.
    if (!options.view.spectrogram_of.empty() &&
        !choice_of(page.choices, options.view.spectrogram_of)) {
      for (const std::string& choice : page.choices)
        others += (others.empty() ? "" : "; ") + choice;
      continue;
    }
    if (!document.note.empty() && !page.panels.empty())
      page.note = "Incomplete file: " + document.note + ". " + page.note;
    const fs::path path =
        options.folder / fmt::format("{}-page-{:02}.{}", stem, number, options.format);
    written.push_back(path);
    if (options.figure.is_for_print()) {
      desktop::save_figure(page, path, options.figure, desktop::Replace::OwnPictures);
      continue;
    }
    scene.setPage(std::move(page));
    if (options.format != "png") {
      desktop::save_page(scene, path, QSizeF(options.width, options.height),
                         desktop::Replace::OwnPictures);
      continue;
    }
    desktop::save_image(
        desktop::image_with_findings(
            {options.width, options.height}, findings, options.dark,
            [&](QSize size) {
              scene.setPageSize(QSizeF(size));
              return scene.image(size);
            },
            page_concerns(document.pages[static_cast<std::size_t>(number - 1)].title,
                          document.subject)),
        path);
  }
  const bool left_out = options.figure.is_for_print() || options.format != "png";
  if (left_out && options.tell && !written.empty() && !findings.empty())
    options.tell(fmt::format("{}: the figures do not show {} of the run. First finding: {}",
                             document.path.string(), counted(findings.size(), "finding"),
                             findings.front().message));
  return written;
}

/// @param file name of the requested file; empty: several files
void refuse_curve(const std::string& file, const RenderOptions& options,
                  const std::string& others) {
  throw InputError(
      fmt::format("{} \"{}\" for a spectrogram{}{}{}",
                  file.empty() ? "none of the files has a curve" : file + " has no curve",
                  options.view.spectrogram_of,
                  options.page == 0 ? std::string() : fmt::format(" on page {}", options.page),
                  others.empty() ? ""
                  : file.empty() ? "; they have: "
                                 : "; it has: ",
                  others));
}

/// Prefix of the picture names of a file, which distinguishes it from other files.
std::string stem_of(const fs::path& path, const std::vector<fs::path>& files) {
  const bool twin = std::count_if(files.begin(), files.end(), [&](const fs::path& other) {
                      return other.filename() == path.filename();
                    }) > 1;
  const std::string folder = run_folder(path).filename().string();
  fs::path name = path.filename();
  if (name.empty()) name = path.parent_path().filename();  // "clearance.study/"
  return (twin ? folder + "-" : "") + name.string();
}

/// Message for a file without the requested page.
std::string too_short(const PlotDocument& document) {
  const std::size_t count = document.pages.size();
  return fmt::format("{} has {}", document.path.string(),
                     count == 1 ? "one page" : fmt::format("{} pages", count));
}

}  // namespace

std::vector<fs::path> render_document(const PlotDocument& document, const std::string& stem,
                                      const RenderOptions& options) {
  std::string others;
  std::vector<fs::path> written = draw_document(document, stem, options, others);
  if (written.empty() && !options.view.spectrogram_of.empty())
    refuse_curve(document.path.string(), options, others);
  return written;
}

std::vector<fs::path> render_plots(const std::vector<fs::path>& paths,
                                   const RenderOptions& options) {
  std::vector<fs::path> files;
  for (const fs::path& path : paths)
    for (fs::path& file : plot_files_of(path)) files.push_back(std::move(file));
  desktop::make_folder(options.folder);
  std::vector<fs::path> written;
  std::string others;
  std::vector<std::string> shorter;
  for (const auto& path : files) {
    const PlotDocument document = open_document(path, options.range);
    // A single file rejects the page number itself.
    if (files.size() > 1 && options.page > static_cast<int>(document.pages.size())) {
      shorter.push_back(too_short(document));
    } else {
      const std::size_t more = options.page == 0 ? document.pages.size() : 1;
      if (written.size() + more > kMaxPictures)
        throw InputError(
            fmt::format("{}: {} more would exceed the limit of {} pictures per command; select a "
                        "page with --page, or give fewer files",
                        path.string(), counted(more, "picture"), kMaxPictures));
      const auto pictures = draw_document(document, stem_of(path, files), options, others);
      written.insert(written.end(), pictures.begin(), pictures.end());
    }
    if (options.progress)
      options.progress(&path - files.data() + 1, static_cast<long>(files.size()));
  }
  if (shorter.size() == files.size())
    throw InputError(
        fmt::format("none of the files has a page {}: {}", options.page, fmt::join(shorter, ", ")));
  if (written.empty() && !options.view.spectrogram_of.empty())
    refuse_curve(files.size() == 1 ? files.front().string() : "", options, others);
  if (options.tell)
    for (const std::string& file : shorter)
      options.tell(fmt::format("{}: page {} was not drawn", file, options.page));
  return written;
}

}  // namespace adore::adrplot
