#pragma once

#include <QString>
#include <QStringList>

#include <functional>

/// Starting another program of the suite.
namespace adore::desktop {

/// Starts `program` (adrplot, agore, adrinput) as a program of its own that outlives this one and
/// holds none of its streams. It is looked for beside this program, then in the PATH.
/// @throws InputError when it is not installed or does not start.
void start_program(const QString& program, const QStringList& arguments);

/// Starts the program at a path; false when that failed.
using Starter = std::function<bool(const QString& path, const QStringList& arguments)>;

/// What start_program() starts by from now on (none: as it does by itself), for tests, which must
/// leave no windows behind. Gives what it was.
Starter start_programs_by(Starter start);

}  // namespace adore::desktop
