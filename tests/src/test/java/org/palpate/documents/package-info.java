/**
 * Checks the documents against the sources: links, excerpts of code, command lines, names.
 *
 * <p>The rules stand in {@link DocumentsTest}.
 */
package org.palpate.documents;
