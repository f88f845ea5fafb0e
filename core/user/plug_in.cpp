#include "user/plug_in.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "user/formulas.hpp"

#include <fmt/format.h>

#include <dlfcn.h>

namespace adore::user {
namespace fs = std::filesystem;

std::string hook_name(int hook) { return fmt::format("ADRX{}", hook); }

PlugIn load_plug_in(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error))
    throw InputError(
        fmt::format("there is no plug-in {}; `adore user new adrx7 --lang c` writes an example",
                    file.string()));
  if (file.extension() == ".json") return load_formulas(file);
  reject_special_file(file);  // dlopen() would wait for its other end
  const std::string path = fs::absolute(file).string();
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* why = dlerror();
    throw InputError(
        fmt::format("the plug-in {} cannot be loaded: {}; give a shared object (the makefile of "
                    "`adore user new` builds one) or a .json file of formulas",
                    file.string(), why == nullptr ? "unknown reason" : why));
  }
  PlugIn out;
  out.keeper.reset(library, [](void* handle) { dlclose(handle); });
  out.source = file.string();
  out.foreign = true;
  const auto abi = reinterpret_cast<std::int32_t (*)()>(dlsym(library, "adore_user_abi"));
  if (abi == nullptr)
    throw InputError(
        fmt::format("the plug-in {} does not export adore_user_abi(), so it is not a user routine "
                    "of Adore; `adore user new adrx7 --lang c` writes an example that exports it",
                    out.source));
  if (const std::int32_t version = abi(); version != ADORE_USER_ABI)
    throw InputError(
        fmt::format("the plug-in {} was built for version {} of adore_user.h, and this program has "
                    "version {}; build it again with the header of this program",
                    out.source, version, ADORE_USER_ABI));
  if (const auto text = reinterpret_cast<const char* (*)()>(dlsym(library, "adore_user_version")))
    if (const char* version = text(); version != nullptr) out.version = version;
  bool any = false;
  for (std::size_t k = 0; k < kHooks; ++k) {
    const std::string symbol = fmt::format("adrx{}", k);
    const auto routine =
        reinterpret_cast<std::int32_t (*)(adore_call*)>(dlsym(library, symbol.c_str()));
    if (routine == nullptr) continue;
    out.hooks[k] = [routine](adore_call& call) { return routine(&call); };
    any = true;
  }
  if (!any)
    throw InputError(
        fmt::format("the plug-in {} exports none of the routines adrx0 to adrx9; declare the "
                    "routines extern \"C\" in C++, or bind(C) in Fortran",
                    out.source));
  return out;
}

}  // namespace adore::user
