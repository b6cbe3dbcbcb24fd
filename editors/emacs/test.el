;;; test.el --- The language server in Emacs without a screen, by the lines of README.md  -*- lexical-binding: t -*-
;; Run by editors/test.sh; ASSUR names the program.

(package-initialize)
(require 'eglot)

(defvar here (file-name-directory load-file-name))

;; all the lines to paste
(with-temp-buffer
  (insert-file-contents (expand-file-name "README.md" here))
  (while (re-search-forward "^```elisp\n" nil t)
    (let ((start (point)))
      (re-search-forward "^```$")
      (eval-region start (match-beginning 0)))))
(add-to-list 'eglot-server-programs `(mech-mode ,(or (getenv "ASSUR") "assur") "lsp"))

(defun wait-for (what holds)
  "Wait until HOLDS gives a value, or end with WHAT was waited for."
  (let ((end (+ (float-time) 20)) value)
    (while (and (not (setq value (funcall holds))) (< (float-time) end))
      (accept-process-output nil 0.05))
    (or value (error "waited in vain for %s" what))))

(defun same (got wanted)
  "GOT has to be WANTED."
  (unless (equal got wanted) (error "%S, not %S" got wanted)))

(defun mistakes ()
  "What is wrong, without what is shown faded."
  (seq-remove (lambda (one) (eq (flymake-diagnostic-type one) 'eglot-note)) (flymake-diagnostics)))

(defun accept-fix (place)
  "Apply the first fix at PLACE."
  (let ((actions (eglot-code-actions place (1+ place) "quickfix")))
    (eglot--apply-workspace-edit (plist-get (car (append actions nil)) :edit))
    ;; which waits for an idle user otherwise
    (eglot--signal-textDocument/didChange)))

(let* ((folder (make-temp-file "assur" t))
       (file (expand-file-name "wrong.mech" folder))
       (fixed 0)
       (eglot-sync-connect 20)
       (eglot-autoshutdown t))
  (with-temp-file file
    (insert "mech 1\ngiven  φ=5 mm\nlnk crank A-B φ\nground { A (0, 0) }\nrevolute A: ground - crank\n"))
  (find-file file)
  (same major-mode 'mech-mode)
  (font-lock-ensure)
  (same (get-text-property (point-min) 'face) 'font-lock-keyword-face)
  (apply #'eglot (eglot--guess-contact))
  (flymake-mode 1)
  (let ((found (wait-for "diagnostics" (lambda () (flymake-start) (flymake-diagnostics)))))
    (same (line-number-at-pos (flymake-diagnostic-beg (car found))) 3)
    (unless (string-match-p "help: write: link crank A-B φ" (flymake-diagnostic-text (car found)))
      (error "%s" (flymake-diagnostic-text (car found)))))
  (accept-fix (flymake-diagnostic-beg (car (flymake-diagnostics))))
  (eglot-format-buffer)
  (same (buffer-string)
        "mech 1\ngiven φ = 5 mm\nlink crank A-B φ\nground { A (0, 0) }\nrevolute A: ground - crank\n")
  (set-buffer-modified-p nil)
  ;; each of these files has one mistake with one fix
  (dolist (name (split-string (with-temp-buffer (insert-file-contents (expand-file-name "../fixes.txt" here)) (buffer-string))))
    (copy-file (expand-file-name (format "../../tests/errors/%s.mech" name) here)
               (setq file (expand-file-name (concat (string-replace "/" "-" name) ".mech") folder)))
    (find-file file)
    (eglot--maybe-activate-editing-mode)
    (flymake-mode 1)
    (let ((found (wait-for name (lambda () (flymake-start) (flymake-diagnostics)))))
      (accept-fix (flymake-diagnostic-beg (car found))))
    (wait-for (concat "the fix of " name) (lambda () (flymake-start) (not (mistakes))))
    (setq fixed (1+ fixed))
    (set-buffer-modified-p nil))
  (same fixed 10)
  (eglot-shutdown (eglot-current-server))
  (delete-directory folder t)
  (message "emacs: colours, diagnostics, formatting, %d fixes" fixed))
