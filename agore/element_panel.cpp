#include "agore/element_panel.hpp"

#include "desktop/axis_scale.hpp"
#include "desktop/theme.hpp"
#include "results/run_json.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace adore::agore {
namespace {

/// Of both races; `zero`: 0 is a value, and not "not computed".
struct ContactValue {
  const char *name, *channel;
  bool zero;
};
constexpr std::array<ContactValue, 9> kContact{
    {{"contact load", "contact.load", true},
     {"contact angle", "contact.angle", true},
     {"largest pressure", "contact.pressure", true},
     {"semi-axis a", "contact.half_major", true},
     {"semi-axis b", "contact.half_minor", true},
     {"largest slip", "contact.slip", true},
     {"heat", "contact.heat", true},
     {"film thickness", "contact.film", false},
     {"film parameter", "contact.film_parameter", false}}};
constexpr std::array<ContactValue, 3> kOwn{{{"orbit speed", "element.orbital_velocity", true},
                                            {"angular velocity", "element.angular_velocity", true},
                                            {"pocket heat", "element.pocket_heat", false}}};

std::string text_of(double value, const std::string& unit) {
  if (unit == "rad") {
    constexpr double kDegree = 180.0 / std::numbers::pi;
    return desktop::pretty_number(kDegree * value, 4) + "°";
  }
  return desktop::pretty_quantity(value, unit, 4);
}

}  // namespace

std::vector<ElementRow> element_rows(const Animation& animation, std::size_t frame, int element) {
  std::vector<ElementRow> out;
  if (!animation.motion || animation.behind(frame)) return out;
  const auto k = static_cast<std::size_t>(element - 1);
  const auto touches = [&](std::size_t race) {
    return animation.value("contact.load", frame, 2 * k + race) > 0.0;
  };
  for (const ContactValue& of : kContact) {
    const auto* channel = animation.motion->channel(of.channel);
    if (channel == nullptr) continue;
    std::array<std::string, 2> text;
    bool any = false;
    for (const std::size_t race : {0U, 1U}) {
      const double value = channel->at(frame, 2 * k + race);
      const bool known = std::isfinite(value) && (of.zero || value != 0.0);
      any = any || known;
      text[race] = !known ? "–" : touches(race) ? text_of(value, channel->unit) : "no contact";
    }
    if (any) out.push_back({of.name, text[0], text[1]});
  }
  for (const ContactValue& of : kOwn) {
    const auto* channel = animation.motion->channel(of.channel);
    if (channel == nullptr) continue;
    const double value = channel->at(frame, k);
    if (std::isfinite(value) && (of.zero || value != 0.0))
      out.push_back({of.name, text_of(value, channel->unit), {}});
  }
  if (animation.has_cage)
    out.push_back(
        {"pocket force",
         text_of(animation.frame(frame).elements.at(k).pocket_force, animation.file.units[2]),
         {}});
  return out;
}

std::string fault_frequency_text(const Animation& animation) {
  const std::filesystem::path file = animation.file.path.parent_path() / "RUN.json";
  if (results::read_run_member(file, "run") != animation.file.run_id) return {};
  const nlohmann::json summary = results::read_run_member(file, "summary");
  if (!summary.is_object()) return {};
  std::string out;
  for (const char* name : {"bpfo", "bpfi", "bsf", "ftf"})
    for (const char* kind : {"_Hz", "_nominal_Hz"}) {
      const auto found = summary.find(std::string(name) + kind);
      if (found == summary.end() || !found->is_number()) continue;
      std::string upper(name);
      for (char& c : upper) c = static_cast<char>(c - 'a' + 'A');
      out += fmt::format("{}{} {}", out.empty() ? "" : ", ", upper,
                         desktop::pretty_quantity(found->get<double>(), "Hz", 4));
      break;
    }
  return out;
}

ElementPanel::ElementPanel(QWidget* parent)
    : QFrame(parent),
      title_(new QLabel(this)),
      values_(new QLabel(this)),
      frequencies_(new QLabel(this)) {
  setObjectName("elementPanel");
  setAccessibleName(tr("Values of the element"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  title_->setFont(desktop::ui_font(12, true));
  values_->setObjectName("elementValues");
  values_->setTextFormat(Qt::RichText);
  frequencies_->setObjectName("elementFrequencies");
  frequencies_->setWordWrap(true);
  for (QLabel* label : {values_, frequencies_}) label->setFont(desktop::ui_font(11));
  auto* close = new QToolButton(this);
  close->setObjectName("elementClose");
  close->setText("×");
  close->setAutoRaise(true);
  close->setFocusPolicy(Qt::NoFocus);
  close->setAccessibleName(tr("Close the values of the element"));
  close->setToolTip(tr("Close (I)"));
  connect(close, &QToolButton::clicked, this, &ElementPanel::closed);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(8, 4, 4, 6);
  grid->setVerticalSpacing(2);
  grid->addWidget(title_, 0, 0);
  grid->addWidget(close, 0, 1, Qt::AlignRight);
  grid->addWidget(values_, 1, 0, 1, 2);
  grid->addWidget(frequencies_, 2, 0, 1, 2);
  grid->setColumnStretch(0, 1);
}

void ElementPanel::open(const Animation& animation) {
  const std::string text = fault_frequency_text(animation);
  frequencies_->setText(
      text.empty() ? QString() : tr("Fault frequencies: %1").arg(QString::fromStdString(text)));
  frequencies_->setVisible(!text.empty());
}

void ElementPanel::show(const Animation& animation, std::size_t frame, int element) {
  title_->setText(animation.file.bearing_type == 1 ? tr("Ball %1").arg(element)
                                                   : tr("Roller %1").arg(element));
  const std::vector<ElementRow> rows = element_rows(animation, frame, element);
  QString text;
  if (rows.empty()) {
    text = tr("No values: %1.")
               .arg(QString::fromStdString(animation.missing_loads_reason(frame)).toHtmlEscaped());
  } else {
    const auto cells = [](const QString& name, const QString& outer, const QString& inner) {
      return QString(
                 "<tr><td>%1&nbsp;</td><td align=right>&nbsp;%2</td>"
                 "<td align=right>&nbsp;%3</td></tr>")
          .arg(name, outer, inner);
    };
    text = "<table cellspacing=1>" + cells({}, tr("outer"), tr("inner"));
    for (const ElementRow& row : rows)
      text += cells(QString::fromStdString(row.name), QString::fromStdString(row.outer),
                    QString::fromStdString(row.inner));
    text += "</table>";
  }
  if (values_->text() != text) values_->setText(text);
  // As large as its values, and never smaller: it would jump while the animation plays.
  const QSize wanted = sizeHint().expandedTo(isVisible() ? size() : QSize());
  resize(wanted.boundedTo(parentWidget()->size()));
  QFrame::show();
  raise();
}

QString ElementPanel::text() const {
  return title_->text() + "\n" + values_->text() + "\n" + frequencies_->text();
}

}  // namespace adore::agore
