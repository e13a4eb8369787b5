/** Results as files: the result file (JSON) and draws as Stan writes them (CSV). */
package org.cellgauge.output;
