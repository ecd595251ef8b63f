O1 (section 7.4: applied if known)
G10 L50
N1320 P1 R500.25 (expect assumed: does not have this parameter)
G11
M30
