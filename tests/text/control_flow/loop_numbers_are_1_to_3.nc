O1 (CTL-10: there is no DO4)
WHILE[1EQ1]DO4 (expect alarm PS0126)
END4
M30
