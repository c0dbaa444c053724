// One DICOM file, scanned for harm and then parsed by DCMTK.
#pragma once

#include <memory>
#include <string>

#include "io/dicom/elements/dicom_scan.h"
#include "io/files/input_file.h"
#include "processing/progress.h"
#include "processing/result.h"

class DcmDataset;

namespace echolucent {

/// A file as DCMTK has parsed it, and the results of the scan that went before.
class DicomFile {
public:
    /// Scans and parses an opened file. Parsing stops before the pixel data if `headerOnly` is set, and always for a
    /// QLAB volume. `progress` is polled for cancel between elements. Fails if the file is no DICOM, if it is damaged,
    /// if its transfer syntax cannot be read, if it would do harm, or if the person cancelled. Damage behind pixels
    /// that were asked for is no failure: the rest is left out and scan().notes says so.
    [[nodiscard]] static Result<DicomFile> load(const InputFile& input, bool headerOnly, const Progress& progress);
    /// Opens the file at `path`, then scans and parses it.
    [[nodiscard]] static Result<DicomFile> load(const std::string& path, bool headerOnly, const Progress& progress);
    /// Reads what a damaged file still tells: the elements of its header before the damage. Fails if the file is no
    /// DICOM, if an element declares over a MiB more than the file holds, if deflated data are cut or damaged, if the
    /// file would do harm, or if the person cancelled.
    [[nodiscard]] static Result<DicomFile> loadRest(const InputFile& input, const Progress& progress);
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
    std::unique_ptr<DcmDataset> m_dataset;
};

}  // namespace echolucent
