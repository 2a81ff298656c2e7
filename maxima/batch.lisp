;;; What a script needs and Maxima lacks: an exit status, exit_code (n), and no questions.

(in-package :maxima)

(defun $exit_code (code)
  (finish-output)
  #+gcl (si::quit code)
  #+sbcl (sb-ext:exit :code code :abort t)
  #+clisp (ext:quit code)
  #+ecl (si:quit code)
  #+ccl (ccl:quit code))

;;; "Is length positive?" would be asked for ever where nobody answers.
(defun retrieve (question flag)
  (declare (ignore flag))
  (merror "Maxima asks a question (assume its answer): ~M"
          (cons '(mtext) (if (listp question) (cdr question) (list question)))))

;;; earlier (a, b): the order of terms and factors in print is that of their texts without number, as the letters are
;;; coded, what stands in parentheses last.
(defun $earlier (a b)
  (if (string< (sorting-key a) (sorting-key b)) t nil))

(defun sorting-key (text)
  (let ((key (string-left-trim "-0123456789*" text)))
    (if (and (> (length key) 0) (char= (char key 0) #\()) (concatenate 'string "~" key) key)))
