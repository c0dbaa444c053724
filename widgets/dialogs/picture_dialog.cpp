#include "widgets/dialogs/picture_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

enum PictureWidth { asOnScreen, twice, ofPage };

}  // namespace

PictureDialog::PictureDialog(const Facts& facts, QWidget* parent)
    : QDialog(parent),
      m_facts(facts),
      m_only3d(named(new QRadioButton(tr("&3D picture")), "pictureDialog.only3d", tr("3D picture"))),
      m_allPanes(named(new QRadioButton(tr("All &panes as shown")), "pictureDialog.allPanes", tr("All panes as shown"),
                       tr("The planes with their lines and measurements, and the 3D picture"))),
      m_size(named(new QComboBox, "pictureDialog.size", tr("Size"))),
      m_pixels(named(secondaryLabel(), "pictureDialog.pixels", tr("Width and height in pixels"))),
      m_save(named(new QPushButton(tr("&Save…")), "pictureDialog.save", tr("Save the picture"))) {
    setObjectName("pictureDialog");
    setAccessibleName(tr("Save picture"));
    setWindowTitle(tr("Save picture"));
    m_size->addItem(tr("As on the screen"), asOnScreen);
    m_size->addItem(tr("Twice as wide"), twice);
    m_size->addItem(tr("Width of a page, 300 dpi"), ofPage);
    selectData(m_size, twice);
    enableOrSayWhy(*m_only3d, !facts.of3d.isEmpty(), tr("The 3D picture is not shown."));
    enableOrSayWhy(*m_allPanes, facts.planesAreShown, tr("No plane is shown. F3 shows planes A, B and C."));
    (facts.planesAreShown ? m_allPanes : m_only3d)->setChecked(true);
    auto* buttons = new QDialogButtonBox;
    buttons->addButton(m_save, QDialogButtonBox::AcceptRole);
    auto* cancel = buttons->addButton(QDialogButtonBox::Cancel);
    named(cancel, "pictureDialog.cancel", tr("Cancel"));
    for (QAbstractButton* button : buttons->buttons()) button->setIcon({});
    auto* form = new QFormLayout;
    form->addRow(m_only3d);
    form->addRow(m_allPanes);
    form->addRow(labelFor(m_size, tr("S&ize")), m_size);
    form->addRow(QString(), m_pixels);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    if (!facts.note.isEmpty()) layout->addWidget(noteLabel(facts.note, "pictureDialog.note"));
    layout->addWidget(buttons);
    setMinimumWidth(360);
    m_save->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_size, &QComboBox::currentIndexChanged, this, &PictureDialog::showPixels);
    connect(m_allPanes, &QRadioButton::toggled, this, &PictureDialog::showPixels);
    showPixels();
}

QSize PictureDialog::onScreen() const { return m_allPanes->isChecked() ? m_facts.ofPanes : m_facts.of3d; }

QSize PictureDialog::chosenSize() const {
    const QSize screen = onScreen();
    switch (m_size->currentData().toInt()) {
        case twice: return screen * 2;
        case ofPage: return screen * (static_cast<double>(pageWidth) / std::max(1, screen.width()));
        default: return screen;
    }
}

void PictureDialog::showPixels() {
    const QSize size = chosenSize();
    const bool isTooLarge = std::max(size.width(), size.height()) > longestEdge;
    m_pixels->setText(size.isEmpty() ? tr("No pane is shown.")
                                     : tr("%1 × %2 pixels").arg(size.width()).arg(size.height()));
    enableOrSayWhy(*m_save, !size.isEmpty() && !isTooLarge,
                   isTooLarge ? tr("No edge may have more than %1 pixels. Choose a smaller size.").arg(longestEdge)
                              : tr("No pane is shown."));
}

PictureChoice PictureDialog::choice() const {
    const bool isForPaper = m_size->currentData().toInt() == ofPage;
    return {m_allPanes->isChecked(), chosenSize().width(), isForPaper ? pageDotsPerInch : 0};
}

}  // namespace echolucent
