O1 (LEX-12: there are no strings)
G00 "X1." (expect alarm PS0009)
M30
