
  
%

O1 (as editors leave them)

#100=1 (expect #100=1)
M30

%

%
