O1 (section 3.5: the two columns are added)
#11001=100.
#10001=-0.25
G43 H1 Z0
#100=#5083 (expect #100=99.75)
M30
