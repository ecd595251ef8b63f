O1 (M98 Q: a local subprogram)
M98 Q100
#101=#100 (expect #101=5)
M30
N100 #100=5
M99
