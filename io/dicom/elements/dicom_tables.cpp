#include "io/dicom/elements/dicom_tables.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <iconv.h>

#include <array>
#include <mutex>

namespace echolucent {

void loadDicomTables() {
    static std::once_flag once;
    std::call_once(once, [] {
        static_cast<void>(dcmDataDict.rdlock().isDictionaryLoaded());
        dcmDataDict.rdunlock();
        // The character sets of DICOM (PS3.3, C.12.1.1.2). A table stays loaded while one conversion is open, so close
        // none.
        constexpr std::array names{"ISO-8859-1", "ISO-8859-2", "ISO-8859-3",  "ISO-8859-4",  "ISO-8859-5",
                                   "ISO-8859-6", "ISO-8859-7", "ISO-8859-8",  "ISO-8859-9",  "ISO-8859-15",
                                   "TIS-620",    "GB18030",    "GBK",         "GB2312",      "EUC-KR",
                                   "EUC-JP",     "SHIFT_JIS",  "ISO-2022-JP", "ISO-2022-KR", "ISO-2022-JP-2"};
        for (const char* name : names) static_cast<void>(iconv_open("UTF-8", name));
    });
}

}  // namespace echolucent
