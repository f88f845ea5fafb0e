#pragma once

#include <filesystem>
#include <functional>

class QWidget;

namespace adore::adrinput {

/// Asks before overwriting a file that another program changed: calls `replace` if the user agrees.
/// The box is a child named "changed".
void ask_to_replace(QWidget* parent, const std::filesystem::path& file,
                    std::function<void()> replace);

}  // namespace adore::adrinput
