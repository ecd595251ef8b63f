O7101() (LEX-13: the title is empty)
#100=1() (expect #100=1)
M30
