O1 (LET in parentheses)
(LET) #100=16 (expect #100=16)
M30
