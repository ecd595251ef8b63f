O1 (LEX-10: if, then, sqrt, while, do and end)
#1=0
if[#1eq0]then#100=sqrt[16] (expect #100=4)
while[#1lt3]do1
#1=#1+1
end1
#101=#1 (expect #101=3)
M30
