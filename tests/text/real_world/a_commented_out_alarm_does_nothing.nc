O1 (statements are often switched off by parentheses)
(#3000=1 TEXT;)
(IF[#1EQ#0]GOTO9)
#100=1 (expect #100=1)
M30
