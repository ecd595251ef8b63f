for i=1 to 3
gosub sub
next i
end
sub: next i ' (expect alarm LB0011 at next)
return
