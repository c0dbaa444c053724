// One DICOM file, scanned for harm and then parsed by DCMTK.
#pragma once

#include <memory>
#include <string>

#include "io/dicom/dicom_scan.h"
#include "processing/result.h"

class DcmDataset;
class DcmFileFormat;

namespace echolucent {

class DicomFile {
public:
    /// headerOnly: stops before the pixel data.
    [[nodiscard]] static Result<DicomFile> load(const std::string& path, bool headerOnly);
    DicomFile(DicomFile&&) noexcept;
    DicomFile& operator=(DicomFile&&) noexcept;
    ~DicomFile();

    [[nodiscard]] DcmDataset& dataset() const;
    [[nodiscard]] const DicomScan& scan() const { return m_scan; }
    [[nodiscard]] const std::string& path() const { return m_path; }

private:
    DicomFile(std::string path, DicomScan scan);
    std::string m_path;
    DicomScan m_scan;
    std::unique_ptr<DcmFileFormat> m_file;
};

}  // namespace echolucent
