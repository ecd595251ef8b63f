O1 (section 7.2: there is no axis 99)
#100=[#_ABSMT[99]] (expect alarm PS1099)
M30
