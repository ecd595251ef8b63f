x=1;y=2
gosub sub
print x;y
end
sub:
local x
x=10;y=20
if y=20 then gosub inner
print x
return
inner:
local x,y
x=100;y=200
return
' (finally prints 10)
' (finally prints 1 20)
