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
      m_pixels(named(secondaryLabel(), "pictureDialog.pixels", tr("Width and height in pixels"))) {
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
    auto* save = buttons->addButton(tr("&Save…"), QDialogButtonBox::AcceptRole);
    auto* cancel = buttons->addButton(QDialogButtonBox::Cancel);
    named(save, "pictureDialog.save", tr("Save the picture"));
    named(cancel, "pictureDialog.cancel", tr("Cancel"));
    for (QAbstractButton* button : buttons->buttons()) button->setIcon({});
    auto* form = new QFormLayout;
    form->addRow(m_only3d);
    form->addRow(m_allPanes);
    form->addRow(labelFor(m_size, tr("S&ize")), m_size);
    form->addRow(QString(), m_pixels);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(buttons);
    setMinimumWidth(360);
    save->setDefault(true);
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
    m_pixels->setText(tr("%1 × %2 pixels").arg(size.width()).arg(size.height()));
}

PictureChoice PictureDialog::choice() const { return {m_allPanes->isChecked(), chosenSize().width()}; }

}  // namespace echolucent
