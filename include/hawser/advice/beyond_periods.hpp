// The end of a table of wave periods that waves are beyond.
#pragma once

namespace hawser::advice {

enum class BeyondPeriods { shorter, longer };

}  // namespace hawser::advice
