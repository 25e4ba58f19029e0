#pragma once

namespace impact {

/// That of package.xml.
const char* version();

}  // namespace impact
