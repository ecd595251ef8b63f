O1 (LEX-33: the alarm comes when the loop reaches its END, not at its DO)
#1=0
WHILE[#1LT3]DO1
#1=#1+1
#100=#1 (expect #100=1)
G00 X#1 END1 (expect alarm PS0127)
M30
