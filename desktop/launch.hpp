#pragma once

#include <QString>
#include <QStringList>

/// Starting another program of the suite.
namespace adore::desktop {

/// Starts `program` (adrplot, agore, adrinput) as a program of its own that outlives this one. It
/// is looked for beside this program, then in the PATH.
/// @throws InputError when it is not installed or does not start.
void start_program(const QString& program, const QStringList& arguments);

}  // namespace adore::desktop
