/**
 * A check on a desktop, for any program: reading photos, finding the inputs of a batch, painting overlays, tables,
 * reports and summaries. It knows no command line.
 *
 * <p>From a photo to a report of it:
 *
 * <pre>{@code
 * Cell cell = CellReader.read(Path.of("cell.yaml"));
 * HtmlReport report = new HtmlReport("cell.yaml", "1.0", Message::toString);
 * SummaryCsv summary = new SummaryCsv();
 * for (CheckInput input : CheckInput.resolve(List.of(Path.of("photos")), List.of()).inputs()) {
 *     GreyImage photo = ImageFiles.read(input.file());
 *     Detections detections = BoofMarkerDetector.forCell(cell).detect(photo, input.name());
 *     CheckResult result = CellCheck.run(cell, detections, CheckSettings.builder().build());
 *     BufferedImage picture = OverlayPainter.paint(photo, CellOverlay.of(result));
 *     report.add(input, result, Pictures.jpeg(picture, 1280));
 *     summary.add(input, result);
 *     System.out.print(CheckText.of(result, Message::toString));
 * }
 * Files.writeString(Path.of("report.html"), report.html("all photos"));
 * Files.writeString(Path.of("summary.csv"), summary.text());
 * }</pre>
 */
package org.cellgauge.desktop;
