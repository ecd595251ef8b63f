O1 (PS1124: END2 alone)
END2 (expect alarm PS1124)
M30
