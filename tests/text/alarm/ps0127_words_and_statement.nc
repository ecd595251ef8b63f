O1 (PS0127: an assignment behind a word)
M08 #1=1 (expect alarm PS0127)
M30
