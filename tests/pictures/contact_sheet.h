// One sheet of many pictures, for people to look at.
#pragma once

#include <QStringList>

/// Writes a sheet with a column for each folder and a row for each picture (*.png) that any of them holds, with their
/// names. Missing pictures stay black. False if nothing could be written.
bool writeContactSheet(const QString& file, const QStringList& folders);
