O1 (K belongs to no arc of G17)
G02 X10. I5. K5. F100 (expect assumed: K5 is ignored)
M30
