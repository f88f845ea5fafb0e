#pragma once

#include <QString>
#include <QStringList>

#include <functional>

class QWidget;

namespace adore::adrinput {

using Launch = std::function<void(const QString& program, const QStringList& arguments)>;

/// Shows files in the only window of a viewer for the project in a folder, or starts it. Names that
/// begin with "--" are options. Errors are shown over `parent`.
void show_in_viewer(QWidget* parent, const Launch& launch, const QString& program,
                    const QString& project, const QStringList& files);

}  // namespace adore::adrinput
