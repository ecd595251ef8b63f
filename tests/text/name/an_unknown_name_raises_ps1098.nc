O1 (section 7.2: nothing was named NOPE)
#100=[#NOPE] (expect alarm PS1098)
M30
