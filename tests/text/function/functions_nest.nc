O1 (section 4.2: a rounded length of a vector)
#1=3.
#2=4.
#100=ROUND[SQRT[#1*#1+#2*#2]*10]/10 (expect #100=5)
#101=ATAN[#2]/[SQRT[25-#2*#2]] (expect #101=53.1301024)
M30
