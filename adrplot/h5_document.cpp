#include "adrplot/h5_document.hpp"

#include "adrplot/domain_page.hpp"
#include "adrplot/known_values.hpp"
#include "adrplot/run_beside.hpp"
#include "adrplot/sentence_words.hpp"
#include "adrplot/spectrum_page.hpp"
#include "base/counted.hpp"
#include "base/errors.hpp"
#include "desktop/figure.hpp"
#include "results/channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <memory>
#include <numbers>

namespace adore::adrplot {
namespace {

using results::H5Reader;
using results::Per;

constexpr std::size_t kMaxPanels = 3, kMaxShown = 8, kFirstShown = 4;

/// Name of an index of a channel (from 0), at a dimension after the step.
std::string index_name(Per per, std::size_t dimension, std::size_t size, std::size_t i) {
  const std::string number = std::to_string(i + 1);
  if (dimension == 0) switch (per) {
      case Per::Element:
      case Per::Contact:
      case Per::Second:
      case Per::Flange:
        return "element " + number;
      case Per::Pocket:
        return "pocket " + number;
      case Per::Pair:
        return "elements " + number + " and " + std::to_string(i + 1 < size ? i + 2 : 1);
      case Per::Cage:
      case Per::Land:
        return size > 1 ? "segment " + number : "cage";
      case Per::Race:
        return i == 0 ? "outer race" : "inner race";
      default:
        break;
    }
  if (dimension == 1) switch (per) {
      case Per::Contact:
      case Per::Second:
      case Per::Flange:
        return i == 0 ? "outer race" : "inner race";
      case Per::Pocket:
        return "surface " + number;
      case Per::Land:
        return "land " + number;
      default:
        break;
    }
  if (dimension == 2 && per == Per::Flange) return i == 0 ? "flange at −x" : "flange at +x";
  if (size == 3) return std::string(1, "xyz"[i]);
  if (size == 4) return std::string(1, "wxyz"[i]);
  return number;
}

/// Dimensions with an index per body; those after them are components.
bool has_bodies(Per per) { return per != Per::Run && per != Per::Thermal; }

/// A channel of the file: its name, unit and factor in the charts.
struct ChannelView {
  H5Reader::ChannelInfo info;
  Per per = Per::Run;
  bool known = false;
  std::string unit;
  double factor = 1.0;  ///< shown = stored / factor
};

ChannelView view_of(const H5Reader::ChannelInfo& info) {
  ChannelView out{info, Per::Run, false, info.unit == "-" ? "" : info.unit, 1.0};
  const auto all = results::channels();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const results::Channel& c) { return c.id == info.id; });
  if (found == all.end()) return out;
  out.per = found->per;
  out.known = true;
  out.unit = found->unit->si == "-" ? "" : std::string(found->unit->si);
  out.factor = found->unit->si_factor;
  return out;
}

/// One curve: its index among the values of a step.
struct CurveView {
  std::string name;
  std::size_t index = 0;
};
struct PanelView {
  std::string title;
  std::vector<CurveView> curves;
};
struct PageView {
  std::size_t channel = 0;  ///< of the views
  std::string title;
  std::vector<PanelView> panels;
};

/// Panels by all indices but the first, curves by the first.
std::vector<PanelView> panels_of(const ChannelView& channel) {
  const std::vector<std::size_t>& sizes = channel.info.dimensions;
  const std::string label = capitalize_first(channel.info.label);
  if (sizes.empty()) {
    PanelView panel{label, {}};
    panel.curves.push_back({"", 0});
    return {panel};
  }
  const bool bodies = has_bodies(channel.per) || !channel.known;
  const std::size_t curves = bodies ? sizes[0] : 1;
  const std::size_t others = curves > 0 ? channel.info.size() / curves : 0;
  std::vector<PanelView> out;
  for (std::size_t o = 0; o < others; ++o) {
    std::string where;
    std::size_t rest = o;
    for (std::size_t d = sizes.size(); d-- > (bodies ? 1U : 0U); rest /= sizes[d])
      where.insert(0, ", " + index_name(channel.per, d, sizes[d], rest % sizes[d]));
    PanelView panel{label + where, {}};
    for (std::size_t c = 0; c < curves; ++c)
      panel.curves.push_back(
          {bodies && curves > 1 ? index_name(channel.per, 0, curves, c) : "", c * others + o});
    out.push_back(std::move(panel));
  }
  return out;
}

/// Values of the shown channels, the last used first.
class H5Pages {
 public:
  H5Pages(std::filesystem::path path, const results::SolRange& range, std::size_t most_values)
      : path_(std::move(path)), reader_(path_), most_(most_values) {
    if (reader_.steps() == 0)
      throw InputError(path_.string() + ": the file contains no complete step yet");
    first_ = static_cast<std::size_t>(std::max<long>(range.from, 1) - 1);
    end_ = std::min(reader_.steps(), static_cast<std::size_t>(std::max<long>(range.to, 1)));
    asked_every_ = static_cast<std::size_t>(std::max<long>(range.every, 1));
    if (first_ >= end_)
      throw InputError(fmt::format("{} has {}; select a step up to {}", path_.string(),
                                   counted(reader_.steps(), "stored step"), reader_.steps()));
    for (const H5Reader::ChannelInfo& info : reader_.channels()) {
      if (info.size() == 0) continue;
      channels_.push_back(view_of(info));
      std::vector<PanelView> panels = panels_of(channels_.back());
      for (std::size_t p = 0; p < panels.size(); p += kMaxPanels) {
        PageView page{channels_.size() - 1, capitalize_first(info.label), {}};
        for (std::size_t k = p; k < std::min(p + kMaxPanels, panels.size()); ++k)
          page.panels.push_back(std::move(panels[k]));
        if (panels.size() > kMaxPanels)
          page.title += fmt::format(", {} of {}", p / kMaxPanels + 1,
                                    (panels.size() + kMaxPanels - 1) / kMaxPanels);
        pages_.push_back(std::move(page));
      }
    }
    marks_ = mark_event_counts(reader_);
  }
  [[nodiscard]] std::vector<PlotDocument::Entry> entries() const {
    std::vector<PlotDocument::Entry> out;
    for (const PageView& page : pages_) {
      const std::string& id = channels_[page.channel].info.id;
      PlotDocument::Entry entry{page.title, PageKind::History};
      entry.group = id.substr(0, id.find('.'));
      for (const PanelView& panel : page.panels) {
        entry.panels.push_back(panel.title);
        std::vector<std::string>& names = entry.curves.emplace_back();
        for (const CurveView& curve : panel.curves) names.push_back(curve.name);
      }
      out.push_back(std::move(entry));
    }
    return out;
  }
  [[nodiscard]] const std::string& run() const { return reader_.run_id(); }
  [[nodiscard]] RunMotion motion() { return motion_over(asked_every_); }

  desktop::ChartPage build(int number, const PageOptions& options) {
    check_page_number(path_, number, pages_.size());
    const PageView& page = pages_[static_cast<std::size_t>(number - 1)];
    const ChannelView& channel = channels_[page.channel];
    const std::size_t every = every_of(channel);
    desktop::ChartPage chart;
    chart.title = page.title;
    chart.about = desktop::kAllChannels;
    chart.note = capitalize_first(channel.info.description);
    if (!chart.note.empty() && chart.note.back() != '.') chart.note += '.';
    chart.subtitle = fmt::format("{}   ·   {}   ·   {}   ·   page {} of {}",
                                 run().empty() ? "(no run name)" : run(), channel.info.id,
                                 path_.filename().string(), number, pages_.size());
    const RunMotion motion = motion_over(every);
    set_axis(chart, motion, every, options);
    add_curves(chart, page, channel, values_of(channel, every));
    if (every > asked_every_)
      add_note(chart,
               fmt::format("Shown: one of every {}; peaks between the shown steps are missing.",
                           counted(every, "stored step")));
    if (!channel.known)
      add_note(
          chart,
          "This version of AdrPlot does not know the channel. Label and unit are from the file.");
    show_domain(chart, motion, options);
    return chart;
  }

 private:
  [[nodiscard]] std::size_t count(std::size_t every) const {
    return (end_ - first_ + every - 1) / every;
  }
  /// So that a channel is at most half of the values that are held.
  [[nodiscard]] std::size_t every_of(const ChannelView& channel) const {
    std::size_t every = asked_every_;
    while (count(every) * channel.info.size() > most_ / 2 && count(every) > 16) every *= 2;
    return every;
  }
  [[nodiscard]] std::vector<double> series(const char* id, std::size_t every) const {
    return reader_.read(id, first_, count(every), every);
  }
  [[nodiscard]] RunMotion motion_over(std::size_t every) {
    RunMotion out{series("time", every), series("shaft_rotation", every), marks_,
                  "shaft_rotation in RESULTS.h5", oscillates(every)};
    double sum = 0.0, last = out.turns.front();
    for (double& turn : out.turns) {
      sum += std::abs(turn - last);
      last = turn;
      turn = sum / (2.0 * std::numbers::pi);
    }
    return out;
  }
  [[nodiscard]] bool oscillates(std::size_t every) const {
    constexpr double kLeast = 2e-3 * std::numbers::pi;
    const std::vector<double> angle = series("shaft_rotation", every);
    double forward = 0.0, backward = 0.0;
    for (std::size_t i = 1; i < angle.size(); ++i)
      (angle[i] > angle[i - 1] ? forward : backward) += std::abs(angle[i] - angle[i - 1]);
    return std::min(forward, backward) > kLeast;
  }
  void set_axis(desktop::ChartPage& chart, const RunMotion& motion, std::size_t every,
                const PageOptions& options) const {
    Abscissa abscissa = options.abscissa;
    constexpr double kLeastTurn = 1e-9;
    if (abscissa == Abscissa::Revolutions && motion.turns.size() > 1 &&
        !(motion.turns.back() - motion.turns.front() > kLeastTurn)) {
      add_note(chart, "The races do not rotate relative to each other, so the abscissa is time.");
      abscissa = Abscissa::Time;
    }
    switch (abscissa) {
      case Abscissa::Revolutions:
        chart.x = motion.turns, chart.x_title = "Bearing rotation", chart.x_unit = "rev";
        break;
      case Abscissa::Time:
        chart.x = motion.times, chart.x_title = "Time", chart.x_unit = "s";
        break;
      case Abscissa::Step:
        chart.x = series("step", every), chart.x_title = "Step";
        break;
    }
  }
  static void add_curves(desktop::ChartPage& chart, const PageView& page,
                         const ChannelView& channel, const std::vector<double>& values) {
    const std::size_t width = channel.info.size(), steps = values.size() / width;
    for (const PanelView& view : page.panels) {
      desktop::ChartPanel panel{view.title, channel.unit, {}, false};
      const bool angle = channel.unit == "deg";
      bool one_turn = angle;
      for (std::size_t c = 0; c < view.curves.size(); ++c) {
        desktop::ChartCurve curve{view.curves[c].name, {}, {}};
        curve.y.reserve(steps);
        for (std::size_t i = 0; i < steps; ++i) {
          const double v = values[i * width + view.curves[c].index] / channel.factor;
          curve.y.push_back(v);
          one_turn = one_turn && !(std::abs(v) > 360.0 + 1e-6);
        }
        curve.hidden = view.curves.size() > kMaxShown && c >= kFirstShown;
        panel.curves.push_back(std::move(curve));
      }
      panel.wraps = one_turn;
      if (std::none_of(panel.curves.begin(), panel.curves.end(),
                       [](const auto& curve) { return has_number(curve.y); }))
        panel.message = "This channel was not computed in this run.";
      chart.panels.push_back(std::move(panel));
    }
  }
  const std::vector<double>& values_of(const ChannelView& channel, std::size_t every) {
    const auto found = std::find_if(held_.begin(), held_.end(),
                                    [&](const Held& one) { return one.id == channel.info.id; });
    if (found != held_.end()) {
      held_.splice(held_.begin(), held_, found);
      return held_.front().values;
    }
    std::size_t all = count(every) * channel.info.size();
    for (const Held& one : held_) all += one.values.size();
    for (; !held_.empty() && all > most_; held_.pop_back()) all -= held_.back().values.size();
    held_.push_front({channel.info.id, reader_.read(channel.info.id, first_, count(every), every)});
    return held_.front().values;
  }

  struct Held {
    std::string id;
    std::vector<double> values;
  };
  std::filesystem::path path_;
  H5Reader reader_;
  std::size_t most_, first_ = 0, end_ = 0, asked_every_ = 1;
  std::vector<ChannelView> channels_;
  std::vector<PageView> pages_;
  std::vector<MarkEventCounts> marks_;
  std::list<Held> held_;
};

}  // namespace

PlotDocument open_h5(const std::filesystem::path& path, const results::SolRange& range,
                     std::size_t most_values) {
  const auto pages = std::make_shared<H5Pages>(path, range, most_values);
  PlotDocument out;
  out.path = path;
  out.subject = "all channels";
  out.pages = pages->entries();
  out.build = [pages](int number, const PageOptions& options) {
    return pages->build(number, options);
  };
  out.motion = [pages] { return pages->motion(); };
  return out;
}

}  // namespace adore::adrplot
