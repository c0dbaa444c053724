#include "widgets/dialogs/movie_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "widgets/controls/number_box.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/controls/short_spin_box.h"

namespace echolucent {

namespace {

constexpr int leastEdge = 16, largestEdge = 4096;
constexpr QSize moviePresets[] = {{512, 512}, {1280, 720}, {1920, 1080}};

int even(int edge) { return edge - edge % 2; }

QString pictureSizeText(const QSize& size) { return QObject::tr("%1 × %2").arg(size.width()).arg(size.height()); }

}  // namespace

MovieDialog::MovieDialog(FrameOutput output, Facts facts, QWidget* parent)
    : QDialog(parent), m_output(output), m_facts(std::move(facts)) {
    setObjectName("movieDialog");
    const bool movie = m_output == FrameOutput::movie;
    setWindowTitle(movie ? tr("Save movie") : tr("Save picture series"));
    setAccessibleName(windowTitle());
    createControls();
    arrange();
    showChoice(m_facts.choice);
}

void MovieDialog::createControls() {
    m_preset = named(new QComboBox, "movieDialog.preset", tr("Size"));
    for (const QSize& size : moviePresets) m_preset->addItem(pictureSizeText(size), size);
    const QSize ofView = m_facts.ofView.boundedTo({largestEdge, largestEdge});
    if (!ofView.isEmpty()) m_preset->addItem(tr("as the view, %1").arg(pictureSizeText(ofView)), ofView);
    m_preset->addItem(tr("other"), QSize());
    connect(m_preset, &QComboBox::activated, this, &MovieDialog::takePreset);
    const auto edge = [this](const QString& name, const QString& words) {
        auto* box = named(new WholeNumberBox, name, words);
        box->setRange(leastEdge, largestEdge);
        box->setSuffix(tr(" px"));
        if (m_output == FrameOutput::movie) {
            box->setSingleStep(2);
            connect(box, &QSpinBox::editingFinished, box, [box] { box->setValue(even(box->value())); });
        }
        connect(box, &QSpinBox::valueChanged, this, &MovieDialog::look);
        return box;
    };
    m_width = edge("movieDialog.width", tr("Width"));
    m_height = edge("movieDialog.height", tr("Height"));
    m_rate = named<QDoubleSpinBox>(new ShortSpinBox, "movieDialog.rate", tr("Frames a second"));
    m_rate->setDecimals(3);
    m_rate->setRange(leastRate, largestRate);
    connect(m_rate, &QDoubleSpinBox::valueChanged, this, &MovieDialog::look);
    const QString lengthTip =
        tr("How long the movie is. A loop is once over the rotation or, if none plays, once through the volumes that "
           "play");
    m_length = named<QDoubleSpinBox>(new ShortSpinBox, "movieDialog.length", tr("Length"), lengthTip);
    connect(m_length, &QDoubleSpinBox::valueChanged, this, &MovieDialog::look);
    m_lengthUnit = named(new QComboBox, "movieDialog.lengthUnit", tr("Unit of the length"), lengthTip);
    m_lengthUnit->addItem(tr("loops"), static_cast<int>(MovieLengthUnit::loops));
    m_lengthUnit->addItem(tr("seconds"), static_cast<int>(MovieLengthUnit::seconds));
    connect(m_lengthUnit, &QComboBox::currentIndexChanged, this, &MovieDialog::takeLengthUnit);
    m_labels = named(new QCheckBox(tr("Caption, scale bar, axes, frame and measurements")), "movieDialog.labels",
                     tr("Labels in the pictures"));
    connect(m_labels, &QCheckBox::toggled, this, &MovieDialog::look);
    m_path = named(new QLineEdit, "movieDialog.path", tr("File"));
    connect(m_path, &QLineEdit::textChanged, this, [this] {
        m_replace->setChecked(false);  // the tick was meant for another file
        look();
    });
    m_choosePath = named(new QPushButton(tr("Choose…")), "movieDialog.choosePath", tr("Choose a file"));
    m_choosePath->setAutoDefault(false);
    connect(m_choosePath, &QPushButton::clicked, this, [this] {
        if (const QString path = m_facts.choosePath(choice().path); !path.isEmpty()) showPath(path);
    });
    m_sentence = named(new QLabel, "movieDialog.sentence", tr("What stands in the way"));
    m_sentence->setTextFormat(Qt::PlainText);  // file names may hold anything
    m_sentence->setWordWrap(true);
    m_replace = named(new QCheckBox(tr("Replace what is there")), "movieDialog.replace", tr("Replace what is there"));
    connect(m_replace, &QCheckBox::toggled, this, &MovieDialog::look);
}

void MovieDialog::arrange() {
    const bool movie = m_output == FrameOutput::movie;
    auto* plays = named(new QLabel(m_facts.plays), "movieDialog.plays", tr("What plays"));
    plays->setTextFormat(Qt::PlainText);
    plays->setWordWrap(true);
    auto* size = new QHBoxLayout;
    size->addWidget(m_preset, 1);
    size->addWidget(m_width);
    size->addWidget(new QLabel(QStringLiteral("×")));
    size->addWidget(m_height);
    auto* path = new QHBoxLayout;
    path->addWidget(m_path, 1);
    path->addWidget(m_choosePath);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
    m_save = named(buttons->button(QDialogButtonBox::Save), "movieDialog.save", windowTitle());
    m_cancel = named(buttons->button(QDialogButtonBox::Cancel), "movieDialog.cancel", tr("Cancel"));
    for (QAbstractButton* button : buttons->buttons()) button->setIcon({});
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        if (m_save->isEnabled()) accept();  // a number that was taken only now may stand in the way
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    // Keep two lines for the sentence and a row for the tick below it, so that the dialog does not jump.
    m_sentence->setMinimumHeight(2 * m_sentence->fontMetrics().lineSpacing());
    m_sentence->setAlignment(Qt::AlignTop);
    QSizePolicy keepsRoom = m_replace->sizePolicy();
    keepsRoom.setRetainSizeWhenHidden(true);
    m_replace->setSizePolicy(keepsRoom);

    auto* length = new QHBoxLayout;
    length->addWidget(m_length);
    length->addWidget(m_lengthUnit);
    length->addStretch(1);

    auto* grid = new QGridLayout(this);
    grid->addWidget(new QLabel(tr("Plays")), 0, 0);
    grid->addWidget(plays, 0, 1);
    grid->addWidget(labelFor(m_preset, tr("Size")), 1, 0);
    grid->addLayout(size, 1, 1);
    if (movie) {
        grid->addWidget(labelFor(m_rate, tr("Frames a second")), 2, 0);
        grid->addWidget(m_rate, 2, 1, Qt::AlignLeft);
        grid->addWidget(labelFor(m_length, tr("Length")), 3, 0);
    } else {
        for (QWidget* ofMovie :
             {static_cast<QWidget*>(m_rate), static_cast<QWidget*>(m_length), static_cast<QWidget*>(m_lengthUnit)})
            ofMovie->hide();
        m_rate->setParent(this);
    }
    grid->addLayout(length, 3, 1);
    grid->addWidget(labelFor(m_labels, tr("Labels")), 4, 0);
    grid->addWidget(m_labels, 4, 1);
    grid->addWidget(labelFor(m_path, movie ? tr("File") : tr("Files")), 5, 0);
    grid->addLayout(path, 5, 1);
    grid->addWidget(m_sentence, 6, 1);
    grid->addWidget(m_replace, 7, 1);
    if (!m_facts.note.isEmpty()) grid->addWidget(noteLabel(m_facts.note, "movieDialog.note"), 8, 0, 1, 2);
    grid->addWidget(buttons, 9, 0, 1, 2);
    grid->setColumnStretch(1, 1);
    followTyping(*this, *m_save, [this] { look(); });
    resize(620, sizeHint().height());
}

void MovieDialog::showChoice(const MovieChoice& choice) {
    showLength(choice.length);
    m_width->setValue(choice.size.width());
    m_height->setValue(choice.size.height());
    m_rate->setValue(choice.framesPerSecond);
    m_labels->setChecked(choice.labels);
    showPath(choice.path);
    look();
}

void MovieDialog::showPath(const QString& path) {
    const QFileInfo file(path);
    m_folder = file.absoluteDir();
    m_path->setText(m_facts.folderShown ? path : file.fileName());
}

void MovieDialog::takePreset(int index) {
    const QSize size = m_preset->itemData(index).toSize();
    if (size.isEmpty()) return m_width->setFocus();
    const bool movie = m_output == FrameOutput::movie;
    m_width->setValue(movie ? even(size.width()) : size.width());
    m_height->setValue(movie ? even(size.height()) : size.height());
}

void MovieDialog::showLength(const MovieLength& length) {
    const bool loops = length.unit == MovieLengthUnit::loops;
    const QSignalBlocker unit(m_lengthUnit), number(m_length);
    m_unit = length.unit;
    selectData(m_lengthUnit, static_cast<int>(length.unit));
    m_length->setDecimals(loops ? 0 : 1);
    m_length->setRange(loops ? 1.0 : leastSeconds, loops ? mostLoops : mostSeconds);
    m_length->setValue(length.amount);
}

/// Keeps the movie about as long as it was.
void MovieDialog::takeLengthUnit() {
    const auto unit = static_cast<MovieLengthUnit>(m_lengthUnit->currentData().toInt());
    if (unit == m_unit) return;
    const double amount = m_length->value();
    showLength({unit, unit == MovieLengthUnit::loops ? std::max(1.0, std::round(amount / loopSeconds()))
                                                     : amount * loopSeconds()});
    look();
}

MovieLength MovieDialog::length() const { return {m_unit, m_length->value()}; }

double MovieDialog::loopSeconds() const {
    return std::accumulate(m_facts.held.pictures.begin(), m_facts.held.pictures.end(), 0) / m_rate->value();
}

/// How long the movie or the series is.
QString MovieDialog::lengthWords(const MovieChoice& chosen) const {
    if (m_output == FrameOutput::series) return tr("%1 pictures").arg(m_facts.held.pictures.size());
    const auto frames = framesOfPictures(m_facts.held.pictures, chosen.length, chosen.framesPerSecond).size();
    return tr("%1 frames, %2 s")
        .arg(frames)
        .arg(QLocale::c().toString(static_cast<double>(frames) / chosen.framesPerSecond, 'f', 1));
}

MovieChoice MovieDialog::choice() const {
    const bool movie = m_output == FrameOutput::movie;
    const QSize size(m_width->value(), m_height->value());
    const QString path = m_path->text();
    return {.path = path.isEmpty() ? path : m_folder.filePath(path),
            .size = movie ? QSize(even(size.width()), even(size.height())) : size,
            .framesPerSecond = m_rate->value(),
            .length = length(),
            .labels = m_labels->isChecked(),
            .replace = m_replace->isChecked()};
}

void MovieDialog::look() {
    const MovieChoice chosen = choice();
    int preset = m_preset->count() - 1;
    for (int i = preset - 1; i >= 0; --i) {
        const QSize size = m_preset->itemData(i).toSize();
        if (size == chosen.size || QSize(even(size.width()), even(size.height())) == chosen.size) preset = i;
    }
    m_preset->setCurrentIndex(preset);
    const MovieHindrance hindrance = m_facts.hindrance(chosen);
    m_sentence->setText(hindrance.sentence.isEmpty() ? lengthWords(chosen) : hindrance.sentence);
    m_replace->setVisible(hindrance.replaces);
    m_save->setEnabled(hindrance.sentence.isEmpty() || (hindrance.replaces && chosen.replace));
}

}  // namespace echolucent
