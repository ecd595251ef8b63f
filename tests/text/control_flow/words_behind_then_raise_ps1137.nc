O1 (CTL-5: THEN takes a macro statement only)
#1=1
IF[#1EQ1]THEN G00 X1. (expect alarm PS1137)
M30
(finally moves: none)
