O1 (NUL-1: #100=#0)
#100=7
#100=#0 (expect #100=null)
IF[#100EQ#0]THEN #101=1 (expect #101=1)
M30
