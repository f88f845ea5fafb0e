#pragma once

#include "results/sol_file.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

/// The commands `plot`, `animate`, `gallery` and `report`: their options, without the drawing code.
/// Two programs use them: `adore`, which passes them on, and `adore-pictures`, which links Qt and
/// draws. Loading the seventy libraries of Qt takes longer than most commands.
namespace adore::cli {

struct PlotRequest {
  std::vector<std::string> files;
  std::string out = ".", progress = "auto", abscissa = "rev", domain = "history", curve, scale,
              rows, band, orders_of;
  int page = 0;              ///< 0: all
  int lubricant = 0;         ///< kTrac of the charts drawn instead of files; 0: none
  double temperature = 0.0;  ///< of its charts [K]; 0: the usual one
  std::string format = "png";
  double width = 0.0;    ///< of figures for print [mm]; 0: pictures for screens
  double height = 0.0;   ///< [mm]; 0: by the number of panels
  double letters = 8.0;  ///< [pt]
  std::string font;      ///< family; empty: font of the program
  bool gray = false;
  results::SolRange range;
  bool dark = false;
};

struct AnimateRequest {
  std::string file, out = ".", view = "bearing", race, colour = "none", scale = "usual", movie,
                    progress = "auto";
  std::string html;  ///< page with the 3D scene
  std::string beside;
  double yaw = 32.0, elevation = 18.0;
  int frame = 0, first = 1, last = 0, every = 1, frames_per_second = 25, element = 1;
  double slow = 0.0;  ///< simulated seconds per second of the film; 0: a picture for each frame
  bool dark = false, contacts = false, trails = false;
};

struct GalleryRequest {
  std::vector<std::string> runs;  ///< folders; none: those of the example decks
  std::string out = "gallery", size = "1280x800", progress = "auto";
  bool dark = false;
};

struct ReportRequest {
  std::vector<std::string> runs;  ///< folders
  std::string out = "report", charts = "main", progress = "auto";
  std::string file;  ///< template; empty: the usual one
  bool print_template = false;
};

struct PictureActions {
  std::function<void(const PlotRequest&)> plot;
  std::function<void(const AnimateRequest&)> animate;
  std::function<void(const GalleryRequest&)> gallery;
  std::function<void(const ReportRequest&)> report;
};

void add_picture_commands(CLI::App& app, const PictureActions& actions);

}  // namespace adore::cli
